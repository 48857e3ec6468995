//! The command line, with one line for each error.

use std::error::Error;
use std::io::{ErrorKind, Write};
use std::process::ExitCode;
use std::str::FromStr;

use clap::Parser;

/// Parses the command line. On an error it prints the error and exits.
pub fn read<Options: Parser>() -> Options {
    Options::try_parse().unwrap_or_else(|error| {
        // A request for help is no mistake.
        if !error.use_stderr() {
            error.exit();
        }
        eprintln!("{}", one_line(&error));
        std::process::exit(2)
    })
}

/// Runs a program with the options that it was given. An error is one line too.
pub fn run<Options: Parser>(
    program: impl FnOnce(&Options) -> Result<(), Box<dyn Error>>,
) -> ExitCode {
    match program(&read()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Prints. A closed pipe is no error.
pub fn say(text: &str) -> Result<(), Box<dyn Error>> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(e.into()),
        _ => Ok(()),
    }
}

/// The error, and the valid values. Tips and usage are left to `--help`.
pub fn one_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let first = text.lines().map(str::trim).take_while(|line| !line.is_empty());
    first.collect::<Vec<_>>().join(" ") + "; --help explains the options"
}

/// A parser of values. `what` describes the valid ones, for the message.
pub fn valid<T: FromStr>(
    what: &'static str,
    is_valid: fn(&T) -> bool,
) -> impl Fn(&str) -> Result<T, String> + Clone {
    move |text| text.parse().ok().filter(is_valid).ok_or_else(|| format!("not {what}"))
}

/// [`valid`] for a type without invalid values.
pub fn any<T: FromStr>(what: &'static str) -> impl Fn(&str) -> Result<T, String> + Clone {
    valid(what, |_| true)
}
