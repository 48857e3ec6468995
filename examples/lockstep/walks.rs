//! Random walks of a capsule: over stairs, where nothing may block it, and over the teapot.

use core::fmt::Write;

use fixed::types::I16F16;
use septum::Vec3;
use septum::contact::{InteriorEdges, interior_edges};
use septum::mesh::{Mesh, Node, Tree};

use super::program::Line;
use super::teapot::{FACES, VERTICES as POINTS};
use super::walker::{Ground, STEP, Walker};

const STEPS: usize = 10_000;
/// The hashes of both walks, the same on every machine.
const LAST: [u64; 2] = [0xfd33_a599_ff76_f809, 0x0400_5cd6_27a4_f2a9];

/// Stairs along x, up and down again.
const TREADS: usize = 16;
const TREAD: I16F16 = I16F16::lit("0.75");
const RISER: I16F16 = I16F16::lit("0.1875");
const WIDTH: I16F16 = I16F16::lit("8");
/// The two ends of each tread, and both sides.
const VERTICES: usize = 4 * TREADS;
const TRIANGLES: usize = 2 * (2 * TREADS - 1);

fn stairs() -> [Vec3<I16F16>; VERTICES] {
    core::array::from_fn(|k| {
        let (tread, is_end, side) = (k / 4, k / 2 % 2, k % 2);
        let height = tread.min(TREADS - 1 - tread);
        Vec3::new(
            TREAD * (tread + is_end) as i32,
            RISER * height as i32,
            if side == 0 { I16F16::ZERO } else { WIDTH },
        )
    })
}

/// Two triangles for each tread and each riser.
fn faces() -> [[u16; 3]; TRIANGLES] {
    core::array::from_fn(|k| {
        let first = (k / 2 * 2) as u16;
        if k % 2 == 0 { [first, first + 1, first + 2] } else { [first + 3, first + 2, first + 1] }
    })
}

/// Random numbers: a linear congruential generator.
struct Draw(u64);

impl Draw {
    /// A direction across the ground.
    fn heading(&mut self) -> [I16F16; 2] {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let turn = I16F16::from_bits((self.0 >> 48) as i32);
        let (sin, cos) = cordic::sin_cos(turn * I16F16::TAU - I16F16::PI);
        [cos, sin]
    }
}

/// What happened on a walk.
#[derive(Default)]
struct Walk {
    /// Steps that were taken: the others have no footing.
    taken: usize,
    /// Steps that went less than a quarter as far as they should, as those against a wall do.
    blocked: usize,
    /// Places where the ground meets the axis of the capsule.
    fallen: usize,
    hash: u64,
}

/// Random headings, each for some steps; `bounds` turn back along x and z.
fn walk(ground: &Ground<'_>, from: [I16F16; 3], bounds: [[I16F16; 2]; 2]) -> Option<Walk> {
    let mut walker = Walker::new(ground, from)?;
    let (mut draw, mut heading) = (Draw(7), [I16F16::ZERO; 2]);
    let mut walk = Walk { hash: 0xcbf2_9ce4_8422_2325, ..Walk::default() };
    for k in 0..STEPS {
        if k % 16 == 0 {
            heading = draw.heading();
        }
        let before = walker.at;
        for (i, [low, high]) in [0, 2].into_iter().zip(bounds) {
            let component = &mut heading[i / 2];
            if before[i] < low && *component < 0 || before[i] > high && *component > 0 {
                *component = -*component;
            }
        }
        if walker.step(ground, heading) {
            walk.taken += 1;
            let [x, z] = [0, 2].map(|i: usize| walker.at[i] - before[i]);
            let along = x * heading[0] + z * heading[1];
            walk.blocked += usize::from(along < STEP / 4);
        } else {
            heading = draw.heading();
        }
        walk.fallen += usize::from(!walker.is_free(ground));
        for byte in walker.at.iter().flat_map(|x| x.to_bits().to_le_bytes()) {
            walk.hash = (walk.hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    Some(walk)
}

fn on_stairs() -> Option<Walk> {
    let (points, faces) = (stairs(), faces());
    let mesh = Mesh::new(&points, &faces).ok()?;
    let mut interior = [InteriorEdges::NONE; TRIANGLES];
    interior_edges(&mesh, &mut [(0, 0); 3 * TRIANGLES], &mut interior).ok()?;
    let mut nodes = [Node::EMPTY; Node::count_for(TRIANGLES)];
    let mut order = [0; TRIANGLES];
    let tree = Tree::build(mesh, &mut nodes, &mut order).ok()?;
    let [x, z] = [TREAD * TREADS as i32, WIDTH];
    let margin = I16F16::ONE / 2;
    let bounds = [x, z].map(|side| [margin, side - margin]);
    walk(&Ground { tree, interior: &interior }, [x / 2, I16F16::lit("4"), z / 2], bounds)
}

fn on_teapot() -> Option<Walk> {
    const COUNT: usize = FACES.len();
    let mesh = Mesh::new(&POINTS, &FACES).ok()?;
    let mut interior = [InteriorEdges::NONE; COUNT];
    interior_edges(&mesh, &mut [(0, 0); 3 * COUNT], &mut interior).ok()?;
    let mut nodes = [Node::EMPTY; Node::count_for(COUNT)];
    let mut order = [0; COUNT];
    let tree = Tree::build(mesh, &mut nodes, &mut order).ok()?;
    let from = [I16F16::ONE, I16F16::lit("16"), I16F16::ZERO];
    let far = I16F16::lit("64");
    walk(&Ground { tree, interior: &interior }, from, [[-far, far]; 2])
}

/// A line about the walk over stairs, or over the teapot.
pub(crate) fn line(k: usize) -> Line {
    let (name, walk) = if k == 0 {
        ("a capsule on stairs", on_stairs())
    } else {
        ("a capsule on the teapot", on_teapot())
    };
    let mut text = heapless::String::new();
    let Some(Walk { taken, blocked, fallen, hash }) = walk else { return (text, false) };
    // No step of the stairs stops it; the teapot has steep sides.
    let is_right = fallen == 0 && hash == LAST[k % 2] && (k > 0 || (taken, blocked) == (STEPS, 0));
    let _ = write!(
        text,
        "{name}: {taken} of {STEPS} steps, {blocked} blocked, {fallen} fallen, hash {hash:016x}{}",
        if is_right { "" } else { " NOT as everywhere" }
    );
    (text, is_right)
}
