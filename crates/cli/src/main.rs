//! The `barchan` program: words in, exit code out.

mod args;
mod asset_file;
mod bake;
mod compare;
mod console;
mod dump;
mod failure;
mod inspect;
mod output;
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
        Err(error) => {
            // Help and version are what was asked for; everything else is a usage error. If the message itself
            // cannot be printed, there is nobody left to tell.
            let _ = error.print();
            return if error.use_stderr() { ExitStatus::Usage.into() } else { ExitCode::SUCCESS };
        }
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

fn run(arguments: &Arguments) -> Result<ExitStatus, Failure> {
    let Arguments { json, progress, .. } = *arguments;
    match &arguments.command {
        Command::Bake(bake) => bake::run(bake, progress, json),
        Command::Inspect(inspect) => inspect::run(inspect, json),
        Command::Dump(dump) => dump::run(dump, json),
        Command::Validate(validate) => validate::run(validate, json),
        Command::Compare(compare) => compare::run(compare, json),
        Command::Render(render) => render::run(render, progress, json),
    }
}
