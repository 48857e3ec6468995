//! Draws the figures of the documentation, each from its own measurement.

use std::error::Error;

use clap::{Parser, Subcommand};
use septum_benches::{chart, order, paper, slivers, stability};

/// Measures and draws the figures of the documentation.
#[derive(Parser)]
#[command(version)]
struct Options {
    #[command(subcommand)]
    figure: Figure,
}

#[derive(Subcommand)]
enum Figure {
    Chart(chart::Options),
    Stability(stability::Options),
    Slivers(slivers::Options),
    Order(order::Options),
    Paper(paper::Options),
}

fn main() -> Result<(), Box<dyn Error>> {
    match Options::parse().figure {
        Figure::Chart(options) => chart::run(&options),
        Figure::Stability(options) => stability::run(&options),
        Figure::Slivers(options) => slivers::run(&options),
        Figure::Order(options) => order::run(&options),
        Figure::Paper(options) => paper::run(&options),
    }
}
