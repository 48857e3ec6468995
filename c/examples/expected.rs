//! What examples/check.c prints, by the crate itself.

use fixed::types::{I8F8, I16F16};
use septum::{Aabb, Facing, Feature, Hit, Obb, Ray, Scalar, Triangle};

const ROUNDS: usize = 256;
const HASH: u32 = 2_166_136_261;

/// xorshift, by Marsaglia (2003).
struct Stream(u32);

impl Stream {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// From -2 to 2, in 65,536ths.
    fn point(&mut self) -> [i32; 3] {
        [(); 3].map(|()| (self.next() >> 14) as i32 - 131_072)
    }
}

fn add(hash: u32, word: u32) -> u32 {
    word.to_le_bytes().iter().fold(hash, |h, &b| (h ^ u32::from(b)).wrapping_mul(16_777_619))
}

fn check<S: Scalar>(name: &str, from: fn(i32) -> S, bits: fn(S) -> u32) {
    let queries = ["triangle_aabb", "triangle_obb", "ray_aabb", "ray_triangle", "ray_triangle_hit"];
    for (query, called) in queries.iter().enumerate() {
        let (mut stream, mut hash, mut yes) = (Stream(1), HASH, 0);
        for _ in 0..ROUNDS {
            let mut point = || stream.point().map(from);
            let triangle = Triangle::new(point(), point(), point()).unwrap();
            let (p, q) = (point(), point());
            let least: [S; 3] = core::array::from_fn(|k| if q[k] < p[k] { q[k] } else { p[k] });
            let most: [S; 3] = core::array::from_fn(|k| if q[k] < p[k] { p[k] } else { q[k] });
            let aabb = Aabb::from_min_max(least, most).unwrap();
            let axes = [[39_322, 52_429, 0], [-52_429, 39_322, 0], [0, 0, 65_536]];
            let half = [65_536, 32_768, 16_384].map(from);
            let obb = Obb::new(point(), axes.map(|axis| axis.map(from)), half).unwrap();
            let ray = Ray::new(point(), point()).unwrap();
            let mut hit = None;
            let answer = match query {
                0 => triangle.overlaps(&aabb),
                1 => triangle.overlaps(&obb),
                2 => ray.overlaps(&aabb),
                3 => ray.is_hit(&triangle),
                _ => {
                    hit = ray.hit(&triangle);
                    hit.is_some()
                }
            };
            yes += u32::from(answer);
            let numbers = hit.map_or([0; 4], |hit| words(&hit, bits));
            hash = numbers.iter().fold(add(hash, u32::from(answer)), |hash, &word| add(hash, word));
        }
        println!("{name} {called} yes: {yes}, hash {hash:x}");
    }
}

fn words<S: Copy>(hit: &Hit<S>, bits: fn(S) -> u32) -> [u32; 4] {
    let feature = match hit.feature {
        Feature::Interior => 0,
        Feature::Edge(k) => 1 + u32::from(k),
        Feature::Vertex(k) => 4 + u32::from(k),
    };
    let front = u32::from(hit.facing == Facing::Front);
    [bits(hit.t), bits(hit.u), bits(hit.v), front << 8 | feature]
}

fn main() {
    check("i8f8", |x| I8F8::from_bits((x / 256) as i16), |x| i32::from(x.to_bits()) as u32);
    check("i16f16", I16F16::from_bits, |x| x.to_bits() as u32);
    check("f32", |x| x as f32 / 65_536.0, f32::to_bits);
    println!("errors are told");
}
