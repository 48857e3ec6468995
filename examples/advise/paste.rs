//! Code to paste: the type, and tables in flash.

use crate::kind::Kind;
use crate::scene::Scene;

/// The type, and a triangle and a box of the scene as constants of it.
pub(crate) fn lines(kind: Kind, scene: &Scene) -> String {
    let points = scene.points(scene.query(0));
    let [a, b, c, min, max] = points.map(|p| vertex(kind, p));
    let (number, vector) = match kind {
        // Raw bits read back unchanged; decimal digits might not.
        Kind::Fixed { bits, .. } => {
            let of = |x: &str| format!("\n        Scalar::from_bits({x}),");
            (format!("i{bits}"), ["x", "y", "z"].map(of).concat() + "\n    ")
        }
        Kind::F32 | Kind::F64 => (kind.name(), "x, y, z".into()),
    };
    format!(
        "\
type Scalar = {};

const fn v(x: {number}, y: {number}, z: {number}) -> septum::Vec3<Scalar> {{
    septum::Vec3::new({vector})
}}

// The first triangle, and the first box that it is tested against.
const TRIANGLE: septum::Triangle<Scalar> = match septum::Triangle::<Scalar>::const_new(
    {a},
    {b},
    {c},
) {{
    Ok(triangle) => triangle,
    Err(_) => unreachable!(),
}};
const CELL: septum::Aabb<Scalar> = match septum::Aabb::<Scalar>::const_new(
    {min},
    {max},
) {{
    Ok(cell) => cell,
    Err(_) => unreachable!(),
}};
",
        kind.path()
    )
}

fn vertex(kind: Kind, point: [f64; 3]) -> String {
    let [x, y, z] = point.map(|x| match kind {
        Kind::Fixed { bits, frac } => {
            format!("{}", Kind::raw(x, bits, frac).expect("a type that holds the scene") as i64)
        }
        Kind::F32 => format!("{:?}", x as f32),
        Kind::F64 => format!("{x:?}"),
    });
    format!("v({x}, {y}, {z})")
}
