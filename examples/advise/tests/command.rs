//! The output of the command line: lines that fit a terminal, or one line with the error.

use std::fs;
use std::path::Path;

use clap::Parser;
use septum_tools::cli::one_line;

use crate::options::Options;

use super::{folder, scaled};

/// The output of the program for these arguments, or its error. Files are in the folder.
fn printed(arguments: &str, files: &Path) -> Result<String, String> {
    let word = |word: &str| if is_file(word) { files.join(word).into() } else { word.into() };
    let words = ["advise".into()].into_iter().chain(arguments.split(' ').map(word));
    let options = Options::try_parse_from::<_, std::ffi::OsString>(words);
    crate::consult(&options.map_err(|error| one_line(&error))?).map_err(|error| error.to_string())
}

fn is_file(word: &str) -> bool {
    word.ends_with(".obj") || word.ends_with(".stl")
}

/// No line has more than 80 columns, whatever the tables contain; only code to paste may.
#[test]
fn all_lines_fit_80_columns() {
    let files = folder("columns");
    for (name, by) in [("tiny.obj", 1e-7), ("odd.obj", 77.7), ("large.obj", 1e12)] {
        let triangles = scaled(by).into_iter().enumerate().map(|(n, t)| {
            let [a, b, c] = t.map(|[x, y, z]| format!("v {x} {y} {z}\n"));
            format!("{a}{b}{c}f {} {} {}\n", 3 * n + 1, 3 * n + 2, 3 * n + 3)
        });
        fs::write(files.join(name), triangles.collect::<String>()).unwrap();
    }
    for arguments in [
        "--sample 100",
        "--cell 2 --full",
        "--target m0 --cell 1 --sample 3000 --full",
        "--target m4f --tolerance 0",
        "--target rv32 --cell 1 --sample 300",
        "--target m0 --cell 0.01 --sample 300",
        "--target m0 --bits 8",
        "--target m0 --bits 16 --tolerance 0.0002",
        "tiny.obj --target m0",
        "odd.obj --target m4f --cell 100 --full",
        "--ask sweep --way 0,-2,0 --target m0 --sample 3000 --full",
        "--ask contact --cell 2 --target m4f --sample 500 --full",
        "large.obj --ask sweep --way 1e12,0,-3e11 --cell 1e9 --sample 100",
        "large.obj --target m0",
        "large.obj --cell 1e9 --sample 500",
    ] {
        let text = printed(arguments, &files).unwrap();
        assert!(text.lines().count() > 30, "{text}");
        for line in text.lines().take_while(|line| !line.starts_with("type Scalar")) {
            assert!(line.chars().count() <= 80, "{arguments}: {line}");
            assert_eq!(line.trim_end(), line, "{arguments}");
        }
    }
}

/// Each of these is refused with one line that contains these words.
#[test]
fn what_is_typed_wrong_costs_one_line() {
    let files = folder("refused");
    fs::write(files.join("far.obj"), "v 1e30 1 1\nv 1e30 1 2\nv 1e30 4 2\nf 1 2 3\n").unwrap();
    for (arguments, says) in [
        ("--cell 0", "above zero"),
        ("--cell nan", "above zero"),
        ("--cell wide", "above zero"),
        ("--cell 1e-300", "boxes of 1.00e-300 are too small"),
        ("--tolerance -1", "zero or above"),
        ("--tolerance inf", "zero or above"),
        ("--tolerance 1e300", "too small"),
        ("--ask rest", "overlap, turned, triangle, polygon, boxes, sweep, contact"),
        ("--ask sweep", "needs the way of the boxes: --way"),
        ("--ask contact --way 1,0,0", "add --ask sweep"),
        ("--ask sweep --way 1,2", "not three numbers"),
        ("--ask sweep --way 0,0,0", "not all zero"),
        ("--ask sweep --way 1e300,0,0", "too far from the origin"),
        ("--target m7", "host, m0, m4f, rv32"),
        ("--bits 7", "from 8 to 64"),
        ("--bits sixteen", "from 8 to 64"),
        ("--sample 0", "above zero"),
        ("--sample -1", "above zero"),
        ("far.obj", "too far from the origin"),
        ("none.stl", "none.stl"),
    ] {
        let error = printed(arguments, &files).unwrap_err();
        assert_eq!(error.lines().count(), 1, "{arguments}: {error}");
        assert!(error.chars().count() < 250, "{arguments}: {error}");
        assert!(error.contains(says), "{arguments}: no `{says}` in {error}");
    }
}

#[test]
fn cores_in_any_case() {
    let text = printed("--target M4F --sample 9", Path::new("")).unwrap();
    assert!(text.contains("for Cortex-M4F"), "{text}");
}

/// The text that `--help` prints is no error.
#[test]
fn help() {
    let help = Options::try_parse_from(["advise", "--help"]).err().unwrap();
    assert!(!help.use_stderr() && help.to_string().contains("Usage:"), "{help}");
}
