//! Fixed-point numbers that examples print read back as the same bits.

use std::ops::Range;

use fixed::types::I16F16;

use super::keep_out::tool;
use super::{directory, printed};

const TEAPOT: &str = include_str!("../../../examples/assets/teapot.obj");

/// The teapot's triangles as the file has them, in `f32`.
fn triangles() -> Vec<[[f64; 3]; 3]> {
    let of = |first: &str| {
        let lines = TEAPOT.lines().map(|line| line.split_whitespace());
        let rest =
            lines.filter_map(move |mut words| (words.next() == Some(first)).then_some(words));
        rest.map(|words| words.map(String::from).collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    let number = |word: &String| f64::from(word.parse::<f32>().unwrap());
    let vertices: Vec<[f64; 3]> =
        of("v").iter().map(|words| [0, 1, 2].map(|i| number(&words[i]))).collect();
    let index = |word: &String| word.split('/').next().unwrap().parse::<usize>().unwrap() - 1;
    let fan = |words: &Vec<String>| {
        let corner = |i: usize| vertices[index(&words[i])];
        (1..words.len() - 1).map(|i| [corner(0), corner(i), corner(i + 1)]).collect::<Vec<_>>()
    };
    of("f").iter().flat_map(fan).collect()
}

/// The integers in a text, as they stand.
fn integers(text: &str) -> Vec<i64> {
    let is_part = |c: char| c.is_ascii_digit() || c == '-';
    text.split(|c| !is_part(c)).filter_map(|word| word.parse().ok()).collect()
}

/// The lines of a table, without its head.
fn body<'a>(table: &'a str, name: &str) -> &'a str {
    let (_, rest) = table.split_once(&format!("static {name}: ")).unwrap();
    let (_, rest) = rest.split_once("= [").unwrap();
    rest.split_once("];").unwrap().0
}

/// The nearest numbers, of all triangles in the order of their tree, in every type.
#[test]
fn tables_for_flash() {
    let directory = directory("printing");
    for (scalar, fraction_bits, scale) in
        [("i4f4", 4, 0.25), ("i8f8", 8, 1.0), ("i16f16", 16, 3.7), ("i32f32", 32, 1e6)]
    {
        let arguments = ["--scalar", scalar, "--scale", &scale.to_string()];
        let [table, _] = printed("quantise", &arguments, &directory);
        let vertices = integers(&body(&table, "VERTICES").replace("v(", " "));
        let faces = integers(body(&table, "FACES"));
        let read: Vec<i64> = faces
            .iter()
            .flat_map(|&i| vertices[3 * i as usize..3 * i as usize + 3].to_vec())
            .collect();
        let sorted = |numbers: &[i64]| {
            let mut triangles: Vec<Vec<i64>> = numbers.chunks(9).map(<[i64]>::to_vec).collect();
            triangles.sort_unstable();
            triangles
        };
        let unit = f64::exp2(-f64::from(fraction_bits));
        let expected: Vec<i64> = triangles()
            .as_flattened()
            .as_flattened()
            .iter()
            .map(|x| (x * scale / unit).round_ties_even() as i64)
            .collect();
        assert!(sorted(&read) == sorted(&expected), "{scalar}");
    }
}

/// The tool at first contact, from the line of the log.
#[test]
fn the_log_of_keep_out() {
    let [log, _] = printed("keep_out", &[], &directory("log"));
    let mut lines = log.lines();
    let first = lines.find(|line| line.starts_with("first contact at step ")).unwrap();
    let read = integers(lines.next().unwrap().trim_start_matches(|c: char| c != '['));
    let tool = tool::at(integers(first)[0] as u32).unwrap();
    let bits = |v: septum::Vec3<I16F16>| v.to_array().map(|x| i64::from(x.to_bits()));
    let [u, v, w] = *tool.axes();
    let shape = [tool.center(), u, v, w, tool.half_extents()].map(bits);
    assert_eq!(integers_of_box(&read), shape);
}

/// Fifteen integers, three by three. The hyphen of "half-extents" is none of them.
fn integers_of_box(read: &[i64]) -> [[i64; 3]; 5] {
    assert_eq!(read.len(), 15, "{read:?}");
    [0, 1, 2, 3, 4].map(|row| [0, 1, 2].map(|i| read[3 * row + i]))
}

/// The log says outside, contact and inside, in the form that `.ci/run` looks for.
#[test]
fn the_states_in_the_log() {
    let [log, _] = printed("keep_out", &[], &directory("states"));
    let steps: Vec<&str> = log.lines().filter(|line| line.starts_with("step ")).collect();
    let with = |words: &str| {
        let has = |line: &&str| line.contains(words);
        let first = steps.iter().position(has).unwrap();
        first..first + steps.iter().copied().filter(|line| has(line)).count()
    };
    let Range { start, end } = with(": touches [");
    assert_eq!(with(": outside"), 0..start);
    assert_eq!(with(": wholly inside part 0"), end..steps.len());
    for (step, line) in steps.iter().enumerate() {
        assert!(line.starts_with(&format!("step {step}: ")), "{line}");
    }
    for line in &steps[start..end] {
        let (named, others) = line.split_once("] and ").unwrap();
        let named = integers(named.split_once('[').unwrap().1).len();
        let others: usize = others.strip_suffix(" more").unwrap().parse().unwrap();
        assert!(named > 0 && (named == 4 || others == 0), "{line}");
    }
}
