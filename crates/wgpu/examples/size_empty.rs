//! The program that `size_plan` is weighed against: it reads a file, and that is all.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("the file is missing")?;
    std::hint::black_box(&std::fs::read(path)?);
    Ok(())
}
