//! The inside of closed meshes. The oracle counts the crossings of an oblique ray, each by three
//! volumes; the crate works along rows.

use dashu_int::IBig;
use septum::Triangle;
use septum::voxel::{Grid, Solid};

use super::oracle::planes;
use super::scene::VoxelScene;
use crate::exact::{Parts, least_exponent, whole};
use crate::{Each, Sample, odd_mantissa};

type Point = [IBig; 3];

/// The result of a check.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Insides {
    /// Centres that are inside.
    pub inside: u64,
    /// Centres on which the oracle and the crate differ.
    pub wrong: u64,
    /// Rows that the crate reports as open.
    pub open: u64,
}

/// Fills the scene's closed mesh, and asks the oracle about every centre.
pub(super) fn check_solid<S: Sample>(scene: &VoxelScene) -> Insides {
    let (grid, triangles) = super::rounded::<S>(scene);
    let (words, open) = filled(&grid, &triangles);
    let mut again: Vec<_> = triangles.iter().map(|t| turned(*t)).collect();
    again.reverse();
    assert!(filled(&grid, &again) == (words.clone(), open), "{}: another order", scene.name);
    let [nx, ny, nz] = grid.resolution();
    let upper = grid.part([nx / 3..nx, 0..ny, 0..nz]).expect("a part");
    let (upper_words, _) = filled(&upper, &triangles);

    let planes = planes(&grid);
    let parts = |x: S| -> Parts { odd_mantissa(x).unwrap_or((0, 0)) };
    let corners: Vec<[[Parts; 3]; 3]> =
        triangles.iter().map(|t| t.vertices().each(|v| v.to_array().each(parts))).collect();
    let limits = planes.each(|p| p.into_iter().map(parts).collect::<Vec<_>>());
    let unit = least_exponent(corners.iter().flatten().flatten().chain(limits.iter().flatten()));
    // Doubled, so that centres are integers, and scaled so that the following displacement changes
    // only signs that are zero: with B bits, volumes have 3·B bits, and normals 2·B.
    let largest = corners.iter().flatten().flatten().chain(limits.iter().flatten());
    let bits = largest.map(|&(m, e)| 65 - m.unsigned_abs().leading_zeros() as i32 + e - unit).max();
    let bits = bits.unwrap_or(0) as usize + 2;
    let (move_by, apart) = (2 * bits + 3, 6 * bits + 12);
    let mesh: Vec<[Point; 3]> =
        corners.iter().map(|t| t.each(|v| v.each(|x| whole(x, unit) << (1 + apart)))).collect();
    let moved = [IBig::from(1) << (2 * move_by), IBig::from(1) << move_by, IBig::from(1)];
    let mut found = Insides { open, ..Insides::default() };
    for voxel in (0..nx * ny * nz).map(|n| [n % nx, n / nx % ny, n / nx / ny]) {
        let center: Point = std::array::from_fn(|i| {
            let at = voxel[i] as usize;
            let both = whole(limits[i][at], unit) + whole(limits[i][at + 1], unit);
            (both << apart) + &moved[i]
        });
        let expected = is_inside(&mesh, &center);
        let get = |grid: &Grid<S>, words: &[u64], [x, y, z]: [u32; 3]| {
            let row = (y + grid.resolution()[1] * z) as usize * grid.row_words::<u64>();
            words[row + x as usize / 64] >> (x % 64) & 1 == 1
        };
        found.inside += u64::from(expected);
        found.wrong += u64::from(get(&grid, &words, voxel) != expected);
        if let Some(x) = voxel[0].checked_sub(nx / 3) {
            let in_part = get(&upper, &upper_words, [x, voxel[1], voxel[2]]);
            found.wrong += u64::from(in_part != expected);
        }
    }
    found
}

/// The words of the inside, and the number of open rows.
fn filled<S: Sample>(grid: &Grid<S>, triangles: &[Triangle<S>]) -> (Vec<u64>, u64) {
    let mut words = vec![u64::MAX; grid.words::<u64>()];
    let mut lines = vec![u64::MAX; grid.line_words::<u64>()];
    let mut solid = Solid::new(grid, &mut words, &mut lines).expect("enough words");
    triangles.iter().for_each(|triangle| solid.cross(triangle));
    solid.finish();
    let open = solid.open_rows().count() as u64;
    (words, open)
}

fn turned<S: Sample>(triangle: Triangle<S>) -> Triangle<S> {
    let [a, b, c] = *triangle.vertices();
    Triangle::new(c, b, a).expect("a triangle")
}

/// Whether a ray from the point crosses an odd number of faces. If it meets an edge, another ray is
/// chosen.
fn is_inside(mesh: &[[Point; 3]], point: &Point) -> bool {
    const RAYS: [[i32; 3]; 4] =
        [[1009, 757, 389], [-523, 1201, 307], [401, -211, 1511], [-907, -613, 1301]];
    let count = RAYS.iter().find_map(|ray| crossings(mesh, point, &ray.each(IBig::from)));
    count.expect("a ray that meets no edge") % 2 == 1
}

fn crossings(mesh: &[[Point; 3]], point: &Point, ray: &Point) -> Option<usize> {
    let mut count = 0;
    for face in mesh {
        let v = face.each_ref().each(|v| -> Point { std::array::from_fn(|i| &v[i] - &point[i]) });
        let along: [IBig; 3] = std::array::from_fn(|k| volume(ray, &v[k], &v[(k + 1) % 3]));
        let sign = |x: &IBig| x.cmp(&IBig::ZERO) as i32;
        let signs = along.each_ref().each(sign);
        if signs.iter().all(|&s| s == signs[0]) && signs[0] != 0 {
            // The crossing is ahead if the tetrahedron with the point has this orientation.
            count += usize::from(sign(&volume(&v[0], &v[1], &v[2])) == signs[0]);
        } else if signs.contains(&0) && !(signs.contains(&1) && signs.contains(&-1)) {
            return None;
        }
    }
    Some(count)
}

fn volume(a: &Point, b: &Point, c: &Point) -> IBig {
    let minor = |j: usize, k: usize| &b[j] * &c[k] - &b[k] * &c[j];
    &a[0] * minor(1, 2) + &a[1] * minor(2, 0) + &a[2] * minor(0, 1)
}
