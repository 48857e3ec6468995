//! The command line, where each mistake costs one line.

use std::str::FromStr;

use clap::Parser;

/// Reads the command line. On a mistake it says which, and ends the program.
pub(crate) fn read<Options: Parser>() -> Options {
    Options::try_parse().unwrap_or_else(|error| {
        // A request for help is no mistake.
        if !error.use_stderr() {
            error.exit();
        }
        eprintln!("{}", one_line(&error));
        std::process::exit(2)
    })
}

/// What is wrong, and what is valid. Tips and usage are left to `--help`.
pub(crate) fn one_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let first = text.lines().map(str::trim).take_while(|line| !line.is_empty());
    first.collect::<Vec<_>>().join(" ") + "; --help explains the options"
}

/// A parser of values. `what` says which are valid, for the message.
pub(crate) fn valid<T: FromStr>(
    what: &'static str,
    is_valid: fn(&T) -> bool,
) -> impl Fn(&str) -> Result<T, String> + Clone {
    move |text| text.parse().ok().filter(is_valid).ok_or_else(|| format!("not {what}"))
}

/// [`valid`] for a type all of whose values are.
pub(crate) fn any<T: FromStr>(what: &'static str) -> impl Fn(&str) -> Result<T, String> + Clone {
    valid(what, |_| true)
}
