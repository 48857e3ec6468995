//! Fixed-point numbers that `quantise` prints read back as the same bits.

use super::{directory, printed};

const TEAPOT: &str = include_str!("../../assets/teapot.obj");

/// The teapot's triangles as the file has them.
fn triangles() -> Vec<[[f64; 3]; 3]> {
    let of = |first: &str| {
        let lines = TEAPOT.lines().map(|line| line.split_whitespace());
        let rest =
            lines.filter_map(move |mut words| (words.next() == Some(first)).then_some(words));
        rest.map(|words| words.map(String::from).collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    let number = |word: &String| word.parse::<f64>().unwrap();
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
