//! What the comments of a shader say of its functions and of the fields of its structures.

/// A function that has a comment: one that other shaders may call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Function {
    /// What stands before its brace, as one line.
    pub(crate) signature: String,
    /// The comment above it, as one line.
    pub(crate) comment: String,
}

impl Function {
    /// What it is called.
    pub(crate) fn name(&self) -> &str {
        let named = self.signature.trim_start_matches("fn ");
        named.split('(').next().unwrap_or(named)
    }
}

/// The functions of a source that have comments, in its order; entry points aside.
pub(crate) fn documented(source: &str) -> Vec<Function> {
    let mut functions = Vec::new();
    let mut comment: Vec<&str> = Vec::new();
    let mut lines = source.lines();
    while let Some(line) = lines.next() {
        if let Some(text) = line.strip_prefix("//") {
            comment.push(text.trim());
            continue;
        }
        if line.starts_with("fn ") && !comment.is_empty() {
            let mut signature = line.to_owned();
            while !signature.ends_with('{') {
                let Some(next) = lines.next() else { break };
                signature += next.trim();
                signature += if next.ends_with(',') { " " } else { "" };
            }
            let signature = signature.trim_end_matches('{').trim_end().replace(", )", ")");
            functions.push(Function { signature, comment: comment.join(" ") });
        }
        comment.clear();
    }
    functions
}

/// The fields of a structure and the comment above each, which also holds for those below it without one.
pub(crate) fn fields(source: &str, structure: &str) -> Vec<(String, String)> {
    let start = format!("struct {structure} {{");
    let lines = source.lines().skip_while(|line| *line != start).skip(1).take_while(|line| *line != "}");
    let (mut fields, mut comment) = (Vec::new(), String::new());
    let mut is_open = false;
    for line in lines.map(str::trim) {
        if let Some(text) = line.strip_prefix("//") {
            if !is_open {
                comment.clear();
            }
            comment += text;
            is_open = true;
        } else if let Some((name, _)) = line.split_once(':') {
            fields.push((name.to_owned(), if is_open { comment.trim().to_owned() } else { String::new() }));
            is_open = false;
        }
    }
    fields
}
