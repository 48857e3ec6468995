//! The look of each test, and its name in a picture.

use crate::drawing::{BLACK, BLUE, GREEN, Mark, ORANGE, PURPLE, VERMILION};

use super::point::Point;

/// A family of tests: one mark, one colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Family {
    pub(super) name: &'static str,
    pub(super) mark: Mark,
    pub(super) color: &'static str,
}

const fn family(name: &'static str, mark: Mark, color: &'static str) -> Family {
    Family { name, mark, color }
}

/// In the order of the legend. A test belongs to the first family whose text occurs in its name.
const FAMILIES: [(&str, Family); 23] = [
    ("parry3d", family("parry3d", Mark::Cross, PURPLE)),
    ("box3d", family("box3d-rust", Mark::Plus, PURPLE)),
    ("obvhs", family("obvhs", Mark::HourGlass, PURPLE)),
    ("embree", family("embree", Mark::Diamond, PURPLE)),
    ("tinybvh", family("tinybvh", Mark::Pentagon, PURPLE)),
    ("Bullet", family("Bullet", Mark::Hexagon, PURPLE)),
    ("Jolt", family("Jolt", Mark::Right, PURPLE)),
    ("bvh", family("bvh", Mark::BowTie, PURPLE)),
    ("exact", family("exact", Mark::Star, BLACK)),
    ("conservative", family("conservative", Mark::Up, GREEN)),
    ("rounded, as published", family("as published", Mark::Square, VERMILION)),
    ("as published", family("as published", Mark::Square, VERMILION)),
    ("11 axes", family("11 axes, as one types them", Mark::Square, VERMILION)),
    ("Guigue", family("Guigue and Devillers", Mark::Diamond, VERMILION)),
    ("15 axes", family("15 axes, four wide", Mark::Square, VERMILION)),
    ("as in C", family("Möller–Trumbore as in C", Mark::Square, VERMILION)),
    ("Möller", family("Möller–Trumbore", Mark::Left, VERMILION)),
    ("stored normal", family("stored normal", Mark::Diamond, BLUE)),
    ("projected", family("projected", Mark::Pentagon, BLUE)),
    ("volumes", family("volumes", Mark::Hexagon, BLUE)),
    ("watertight", family("watertight (Woop)", Mark::Down, ORANGE)),
    ("slopes", family("slopes", Mark::Diamond, BLUE)),
    ("rounded", family("rounded", Mark::Circle, BLUE)),
];

/// The family of a test.
pub(super) fn look(test: &str) -> Family {
    let found = FAMILIES.iter().find(|(part, _)| test.contains(part));
    found.unwrap_or_else(|| panic!("no mark for {test}")).1
}

impl Family {
    /// Its place in a legend: ours before the peers, then in the order above.
    pub(super) fn rank(&self) -> (bool, Option<usize>) {
        (self.color == PURPLE, FAMILIES.iter().position(|(_, family)| family == self))
    }
}

/// Whether a picture shows the point. A yardstick is shown under one name, and pictures with many
/// tests show one form of boxes.
pub(super) fn is_shown(point: &Point) -> bool {
    let is_twice =
        point.test.starts_with("yardstick: as published") && point.picture != "mesh-voxels";
    !is_twice && (point.picture != "ray-box" || point.form != "centre")
}

/// The label beside a mark.
pub(super) fn label(point: &Point) -> String {
    let test = match point.test.as_str() {
        "yardstick: as published" => "as published",
        "yardstick: Möller–Trumbore as in C" => "as in C",
        "Möller–Trumbore as in C, wrapping" => "as in C, wrapping",
        "box3d-rust test_bounds_triangle_overlap" => "box3d-rust",
        "parry3d …_cuboid_triangle" => "parry3d cuboid_triangle",
        "parry3d …_aabb_triangle" => "parry3d aabb_triangle",
        "parry3d cast_local_ray_and_get_normal" => "parry3d cast, normal",
        "parry3d cast_local_ray" | "yardstick: parry3d cast_local_ray" => "parry3d cast",
        "parry3d clip_ray_parameters" => "parry3d clip",
        "obvhs Triangle::intersect" => "obvhs Triangle",
        "obvhs RtTriangle::intersect" => "obvhs RtTriangle",
        "obvhs intersect_ray" => "obvhs",
        "bvh intersects_triangle" => "bvh, culling",
        "bvh intersects_aabb" => "bvh",
        "bvh intersection_slice_for_aabb" => "bvh slice",
        "yardstick: 11 axes" => "11 axes",
        "yardstick: parry3d" => "parry3d",
        "yardstick: parry3d cast_ray" => "parry3d cast_ray",
        "yardstick: parry3d cast_shapes" => "parry3d cast_shapes",
        "yardstick: parry3d manifold" => "parry3d manifold",
        "yardstick: parry3d TriMesh" => "parry3d TriMesh",
        "obvhs Bvh2, slowest build" => "obvhs Bvh2",
        "obvhs CwBvh, slowest build" => "obvhs CwBvh",
        "tinybvh BVH8_CPU, first hit" => "tinybvh, first hit",
        "tinybvh BVH8_CPU, any hit" => "tinybvh, any hit",
        "Bullet btBoxBoxDetector" => "Bullet",
        "Jolt OrientedBox::Overlaps" => "Jolt",
        "slabs, rounded" => "slabs",
        "slabs, rounded t_range" => "slabs t_range",
        "slabs, conservative" => "slabs, conservative",
        "slopes, rounded" => "slopes",
        "slopes, rounded t_enter" => "slopes t_enter",
        "as published (SAT)" => "SAT",
        "segment, as published (SAT)" => "segment SAT",
        "stored normal, t alone" => "stored normal, t only",
        "watertight (Woop)" => "Woop",
        "conservative" if point.picture == "ray-box" => "SAT, conservative",
        other => other,
    };
    let form = match point.form.as_str() {
        _ if point.peer => "",
        "corners" if point.picture.starts_with("triangle") => ", corners",
        form if form.contains("8 at once") => " ×8",
        "ray prepared" if test == "Woop" => ", prepared",
        _ => "",
    };
    format!("{test}{form}")
}
