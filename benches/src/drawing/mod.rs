//! Pictures: SVG, and PNG rendered from it with an embedded font.

mod labels;
mod marks;
mod raster;
mod scale;

use std::error::Error;
use std::path::Path;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use svg::node::element::{Circle, Group, Line, Path as SvgPath, Polyline, Rectangle, Text};
use svg::{Document, Node};
use ttf_parser::Face;

pub(crate) use labels::{Labels, Place};
pub(crate) use marks::Mark;
pub(crate) use scale::{Scale, Zeroed, grouped, power_of, short};

/// The width of a README, in pixels of an unscaled picture.
pub(crate) const WIDTH: f64 = 900.0;
/// PNG pixels for each of these pixels.
const DENSITY: f32 = 2.0;

const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

// Colours that also differ in lightness, after M. Okabe and K. Ito, "Color Universal Design", 2008.
pub(crate) const BLACK: &str = "#000000";
pub(crate) const BLUE: &str = "#0072B2";
pub(crate) const GREEN: &str = "#009E73";
pub(crate) const ORANGE: &str = "#E69F00";
pub(crate) const PURPLE: &str = "#8A3B6F";
pub(crate) const VERMILION: &str = "#D55E00";
pub(crate) const GREY: &str = "#767676";
pub(crate) const LIGHT: &str = "#DDDDDD";
pub(crate) const PALE: &str = "#F0F0F0";

/// The position of a text relative to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }
}

/// A picture in the making.
pub(crate) struct Canvas {
    width: f64,
    height: f64,
    root: Group,
}

impl Canvas {
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Self { width, height, root: Group::new().set("font-family", FAMILY) }
    }

    pub(crate) fn add(&mut self, node: impl Node) {
        self.root.append(node);
    }

    pub(crate) fn line(
        &mut self,
        [x1, y1]: [f64; 2],
        [x2, y2]: [f64; 2],
        color: &str,
        width: f64,
        dash: &str,
    ) {
        let mut line = Line::new()
            .set("x1", round(x1))
            .set("y1", round(y1))
            .set("x2", round(x2))
            .set("y2", round(y2))
            .set("stroke", color)
            .set("stroke-width", width);
        if !dash.is_empty() {
            line = line.set("stroke-dasharray", dash);
        }
        self.add(line);
    }

    pub(crate) fn polyline(&mut self, points: &[[f64; 2]], color: &str, width: f64, dash: &str) {
        let list: Vec<String> =
            points.iter().map(|[x, y]| format!("{},{}", round(*x), round(*y))).collect();
        let mut line = Polyline::new()
            .set("points", list.join(" "))
            .set("fill", "none")
            .set("stroke", color)
            .set("stroke-width", width)
            .set("stroke-linejoin", "round");
        if !dash.is_empty() {
            line = line.set("stroke-dasharray", dash);
        }
        self.add(line);
    }

    /// A rectangle by its upper left corner and size.
    pub(crate) fn rect(&mut self, [x, y]: [f64; 2], [w, h]: [f64; 2], fill: &str) {
        self.add(
            Rectangle::new()
                .set("x", round(x))
                .set("y", round(y))
                .set("width", round(w))
                .set("height", round(h))
                .set("fill", fill),
        );
    }

    pub(crate) fn circle(&mut self, [x, y]: [f64; 2], r: f64, fill: &str, stroke: &str) {
        self.add(
            Circle::new()
                .set("cx", round(x))
                .set("cy", round(y))
                .set("r", r)
                .set("fill", fill)
                .set("stroke", stroke)
                .set("stroke-width", 1.3),
        );
    }

    /// An outline in SVG's own path language.
    pub(crate) fn path(&mut self, data: String, fill: &str, stroke: &str, width: f64) {
        self.add(
            SvgPath::new()
                .set("d", data)
                .set("fill", fill)
                .set("stroke", stroke)
                .set("stroke-width", width)
                .set("stroke-linejoin", "round"),
        );
    }

    /// Unit squares of one colour, as an outline from a corner and at a scale.
    pub(crate) fn pixels(&mut self, data: String, fill: &str, [x, y]: [f64; 2], scale: f64) {
        let place = format!("translate({} {}) scale({scale})", round(x), round(y));
        let path = SvgPath::new().set("d", data).set("fill", fill).set("transform", place);
        self.add(path.set("shape-rendering", "crispEdges"));
    }

    /// A text on its base line.
    pub(crate) fn text(
        &mut self,
        [x, y]: [f64; 2],
        size: f64,
        anchor: Anchor,
        color: &str,
        text: &str,
    ) {
        self.add(words([x, y], size, anchor, color, text));
    }

    pub(crate) fn bold(
        &mut self,
        at: [f64; 2],
        size: f64,
        anchor: Anchor,
        color: &str,
        text: &str,
    ) {
        self.add(words(at, size, anchor, color, text).set("font-weight", "bold"));
    }

    /// A text with a halo.
    pub(crate) fn haloed(&mut self, at: [f64; 2], size: f64, halo: &str, color: &str, text: &str) {
        let halo = words(at, size, Anchor::Start, color, text)
            .set("stroke", halo)
            .set("stroke-width", 2.5)
            .set("stroke-linejoin", "round")
            .set("paint-order", "stroke");
        self.add(halo);
    }

    /// Ends the picture at a height.
    pub(crate) fn crop(&mut self, height: f64) {
        self.height = height;
    }

    /// A text that reads upward.
    pub(crate) fn upright(&mut self, [x, y]: [f64; 2], size: f64, color: &str, text: &str) {
        let turn = format!("rotate(-90 {} {})", round(x), round(y));
        self.add(words([x, y], size, Anchor::Middle, color, text).set("transform", turn));
    }

    /// Lines of text, broken to a width; returns the position of the next line.
    pub(crate) fn paragraph(&mut self, at: [f64; 2], width: f64, size: f64, text: &str) -> f64 {
        let [x, mut y] = at;
        for line in broken(text, size, width) {
            self.text([x, y], size, Anchor::Start, BLACK, &line);
            y += size * 1.4;
        }
        y
    }

    /// Writes `<stem>.svg` and `<stem>.png`.
    pub(crate) fn save(self, stem: &Path) -> Result<(), Box<dyn Error>> {
        let (width, height) = (self.width, self.height.ceil());
        let paper = Rectangle::new().set("width", width).set("height", height).set("fill", "white");
        let document = Document::new()
            .set("viewBox", (0, 0, width, height))
            .set("width", width)
            .set("height", height)
            .add(paper)
            .add(self.root);
        let named = |extension: &str| stem.with_extension(extension);
        let failed = |e: &dyn std::fmt::Display| format!("{}: {e}", stem.display());
        if let Some(folder) = stem.parent() {
            std::fs::create_dir_all(folder).map_err(|e| failed(&e))?;
        }
        let text = format!("{document}\n");
        std::fs::write(named("svg"), &text).map_err(|e| failed(&e))?;

        let mut options = Options { font_family: "DejaVu Sans".into(), ..Options::default() };
        for font in [dejavu::sans::regular(), dejavu::sans::bold()] {
            options.fontdb_mut().load_font_data(font.to_vec());
        }
        options.fontdb_mut().set_sans_serif_family("DejaVu Sans");
        let tree = Tree::from_str(&text, &options)?;
        let side = |length: f64| (length as f32 * DENSITY) as u32;
        let mut pixels = Pixmap::new(side(width), side(height)).ok_or("an empty picture")?;
        resvg::render(&tree, Transform::from_scale(DENSITY, DENSITY), &mut pixels.as_mut());
        std::fs::write(named("png"), raster::encode(&pixels)?).map_err(|e| failed(&e))?;
        Ok(())
    }
}

fn words([x, y]: [f64; 2], size: f64, anchor: Anchor, color: &str, text: &str) -> Text {
    Text::new(text)
        .set("x", round(x))
        .set("y", round(y))
        .set("font-size", size)
        .set("text-anchor", anchor.name())
        .set("fill", color)
}

/// A tenth of a pixel is enough.
fn round(x: f64) -> f64 {
    (x * 10.0).round() / 10.0
}

/// How wide a text is.
pub(crate) fn width_of(text: &str, size: f64) -> f64 {
    thread_local! {
        static FACE: Face<'static> =
            Face::parse(dejavu::sans::regular(), 0).expect("the font is one");
    }
    FACE.with(|face| {
        let advance = |c: char| {
            let glyph = face.glyph_index(c).unwrap_or_default();
            f64::from(face.glyph_hor_advance(glyph).unwrap_or(1200))
        };
        text.chars().map(advance).sum::<f64>() * size / f64::from(face.units_per_em())
    })
}

/// The text in lines of at most that width.
fn broken(text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let last = lines.last_mut().expect("one at least");
        let longer = if last.is_empty() { word.into() } else { format!("{last} {word}") };
        if width_of(&longer, size) > width && !last.is_empty() {
            lines.push(word.into());
        } else {
            *last = longer;
        }
    }
    lines
}
