//! The example `advise`: what it prints fits a terminal. `examples/advise/tests` has the rest.

use std::fs;

use super::{directory, printed};

/// No line has more than 80 columns, whatever the tables hold. Code to paste may.
#[test]
fn all_lines_fit_80_columns() {
    let directory = directory("columns");
    let teapot = include_str!("../../../examples/assets/teapot.obj");
    let scaled = |by: f64| -> String {
        let number = |x: &str| (x.parse::<f64>().unwrap() * by).to_string();
        let line = |line: &str| match line.strip_prefix("v ") {
            Some(p) => {
                format!("v {}", p.split_whitespace().map(number).collect::<Vec<_>>().join(" "))
            }
            None => line.into(),
        };
        teapot.lines().map(line).collect::<Vec<_>>().join("\n")
    };
    for (name, by) in [("tiny.obj", 1e-7), ("odd.obj", 77.7), ("large.obj", 1e12)] {
        fs::write(directory.join(name), scaled(by)).unwrap();
    }
    for arguments in [
        "--sample 100",
        "--cell 2 --full",
        "--target m0 --cell 1 --sample 3000 --full",
        "--target m4f --tolerance 0",
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
        let words: Vec<&str> = arguments.split(' ').collect();
        let [text, errors] = printed("advise", &words, &directory);
        assert!(errors.is_empty(), "{arguments}: {errors}");
        assert!(text.lines().count() > 30, "{text}");
        for line in text.lines().take_while(|line| !line.starts_with("type Scalar")) {
            assert!(line.chars().count() <= 80, "{arguments}: {line}");
            assert_eq!(line.trim_end(), line, "{arguments}");
        }
    }
}
