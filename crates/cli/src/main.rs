//! The `barchan` program: words in, exit code out.

mod args;
mod asset_file;
mod bake;
mod compare;
mod console;
mod curvature_rows;
mod dump;
mod failure;
mod inspect;
mod mesh_words;
mod output;
mod plan;
mod png;
mod progress;
mod render;
mod validate;

use std::process::ExitCode;

use clap::Parser;

use crate::args::{Arguments, Command};
use crate::failure::{ExitStatus, Failure};

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return refuse(&error),
    };
    let json = arguments.json;
    match run(&arguments) {
        Ok(status) => status.into(),
        Err(failure) => {
            console::report_failure(&failure, json);
            failure.status().into()
        }
    }
}

/// Help and version are what was asked for; anything else that clap stops at is a usage error.
fn refuse(error: &clap::Error) -> ExitCode {
    // If the message cannot be printed, there is nobody left to tell.
    let _ = error.print();
    if !error.use_stderr() {
        return ExitCode::SUCCESS;
    }
    if std::env::args_os().any(|word| word == "--json") {
        let text = error.to_string();
        // What follows the first empty line is advice.
        let words: Vec<_> = text.lines().take_while(|line| !line.is_empty()).flat_map(str::split_whitespace).collect();
        let sentence = words.join(" ").trim_start_matches("error: ").to_owned();
        let _ = console::print_error(&Failure::Usage(sentence));
    }
    ExitStatus::Usage.into()
}

fn run(arguments: &Arguments) -> Result<ExitStatus, Failure> {
    let Arguments { json, progress, .. } = *arguments;
    match &arguments.command {
        Command::Bake(bake) => bake::run(bake, progress, json),
        Command::Plan(plan) => plan::run(plan, json),
        Command::Inspect(inspect) => inspect::run(inspect, json),
        Command::Dump(dump) => dump::run(dump, json),
        Command::Validate(validate) => validate::run(validate, json),
        Command::Compare(compare) => compare::run(compare, json),
        Command::Render(render) => render::run(render, progress, json),
    }
}
