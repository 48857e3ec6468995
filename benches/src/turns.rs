//! Methods that take turns with the same questions: their times, and their wrong answers.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// A method that answers all questions of a scene, with a number for each.
pub struct Method<'a> {
    pub name: &'static str,
    pub ask: Box<dyn Fn(usize) -> u64 + 'a>,
}

/// Times the methods in turns, on `count` questions, and counts answers that differ from `truth`.
pub fn race(title: &str, rounds: u32, count: usize, truth: &[u64], methods: &[Method<'_>]) {
    let mut best = vec![Duration::MAX; methods.len()];
    for _ in 0..rounds {
        for (method, best) in methods.iter().zip(&mut best) {
            let start = Instant::now();
            for i in 0..count {
                black_box((method.ask)(black_box(i)));
            }
            *best = start.elapsed().min(*best);
        }
    }
    println!("\n{title}");
    println!("{:34} {:>9} {:>9} {:>8}", "", "ns", "of ours", "wrong");
    for (method, time) in methods.iter().zip(&best) {
        let wrong = truth.iter().enumerate().filter(|(i, t)| (method.ask)(*i) != **t).count();
        let per_million = wrong as f64 * 1e6 / truth.len() as f64;
        println!(
            "{:34} {:9.0} {:9.2} {per_million:8.0}",
            method.name,
            time.as_nanos() as f64 / count as f64,
            time.as_secs_f64() / best[0].as_secs_f64(),
        );
    }
}
