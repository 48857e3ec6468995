use crate::scalar::{Word, out_of_line_if_wide};

/// Whether one of the 13 axes separates a triangle from the box between two
/// corners, for cores on which a product of words is cheap and a wider one is not.
///
/// Each edge axis is looked at from one side only. On x_i × e_k the vertices of
/// edge k fall on nought and the vertex opposite on n_i, the component of the
/// normal. Along x_i we see a triangle and a rectangle in a plane. If they are
/// apart, a side of the rectangle keeps them apart, which is a face of the box, or
/// a side of the triangle with the whole rectangle on its outer side; and n_i
/// tells which side is the outer one. (If n_i is nought the three edges lie on one
/// line, and not all of them run the same way: between them they see both sides.)
///
/// All sums are kept as two words, see [`Word`], and only asked for their sign.
#[inline(never)]
pub(crate) fn one_sided<W: Word>(shapes: &[Shadow<W>; 3]) -> bool {
    if shapes.iter().any(Shadow::is_apart) {
        return true;
    }
    let [x, y, z] = shapes;
    let n = [normal(y, z), normal(z, x), normal(x, y)];
    let turned = [turned(&n[0], y, z), turned(&n[1], z, x), turned(&n[2], x, y)];
    turned.iter().any(|(j, l)| an_edge_misses(j, l))
        || [false, true].iter().any(|&in_mirror| is_behind(shapes, &n, in_mirror))
}

/// A triangle and a box, projected on one coordinate axis.
#[derive(Clone, Copy)]
pub(crate) struct Shadow<W> {
    /// The vertices.
    pub(crate) t: [W; 3],
    /// The ends of the box.
    pub(crate) min: W,
    pub(crate) max: W,
}

impl<W: Word> Shadow<W> {
    /// Whether the axis separates: all three differences have the same sign.
    fn is_apart(&self) -> bool {
        let ([a, b, c], min, max) = (self.t, self.min, self.max);
        ((max - a) & (max - b) & (max - c)) | ((a - min) & (b - min) & (c - min)) < W::ZERO
    }
}

/// The component of the normal along the axis on which j and l follow.
#[inline(always)]
fn normal<W: Word>(j: &Shadow<W>, l: &Shadow<W>) -> Sum<W> {
    out_of_line_if_wide!(W, {
        let ([a, b, c], [p, q, r]) = (j.t, l.t);
        Sum::new(b - a, r - q, c - b, q - p)
    })
}

/// The two axes in the order in which the triangle turns from the first to the
/// second: in a mirror it turns the other way.
#[inline(always)]
fn turned<'a, W: Word>(
    n: &Sum<W>,
    j: &'a Shadow<W>,
    l: &'a Shadow<W>,
) -> (&'a Shadow<W>, &'a Shadow<W>) {
    if n.sign() < W::ZERO { (l, j) } else { (j, l) }
}

/// Whether an edge of a triangle, which turns from `j` to `l`, has the whole box on its
/// outer side: all x with e_j·(x_l − v_l) − e_l·(x_j − v_j) < 0.
#[inline(always)]
fn an_edge_misses<W: Word>(j: &Shadow<W>, l: &Shadow<W>) -> bool {
    let (mut vj, mut vl) = (j.t[2], l.t[2]);
    let (min_j, max_j, min_l, max_l) = (j.min, j.max, l.min, l.max);
    for (&next_j, &next_l) in j.t.iter().zip(&l.t) {
        let (ej, el) = (next_j - vj, next_l - vl);
        let xl = if ej < W::ZERO { min_l } else { max_l };
        let xj = if el < W::ZERO { max_j } else { min_j };
        if W::is_less(xl - vl, ej, xj - vj, el)
            .unwrap_or_else(|| Sum::new(xl - vl, ej, xj - vj, el).sign() < W::ZERO)
        {
            return true;
        }
        (vj, vl) = (next_j, next_l);
    }
    false
}

/// Whether the whole box lies behind the plane of the triangle: its corner farthest
/// along the normal, one of the two critical corners of Haines and Wallace. Or, in
/// a mirror, ahead of it.
#[inline(always)]
fn is_behind<W: Word>(shapes: &[Shadow<W>; 3], n: &[Sum<W>; 3], in_mirror: bool) -> bool {
    out_of_line_if_wide!(W, {
        // In four words, of which the two in the middle have the same weight.
        let (mut s0, mut s1, mut s2, mut s3) = (W::ZERO, W::ZERO, W::ZERO, W::ZERO);
        for (s, n) in shapes.iter().zip(n) {
            let upper = n.sign();
            let corner = if (upper < W::ZERO) ^ in_mirror { s.min } else { s.max };
            let z = if in_mirror { s.t[0] - corner } else { corner - s.t[0] };
            s0 = s0 + (n.lower & W::LOWER) * z;
            s1 = s1 + (upper & W::LOWER) * z;
            s2 = s2 + (upper >> W::SPLIT) * (z & W::LOWER);
            s3 = s3 + (upper >> W::SPLIT) * (z >> W::SPLIT);
        }
        let carry = s1 + (s0 >> W::SPLIT);
        let carry = s2 + (carry >> W::SPLIT);
        s3 + (carry >> W::SPLIT) < W::ZERO
    })
}

/// The sum upper·2^SPLIT + lower, of products of lengths.
#[derive(Clone, Copy)]
struct Sum<W> {
    upper: W,
    lower: W,
}

impl<W: Word> Sum<W> {
    /// a·b − c·d.
    #[inline(always)]
    fn new(a: W, b: W, c: W, d: W) -> Self {
        out_of_line_if_wide!(
            W,
            Self {
                upper: (a >> W::SPLIT) * b - (c >> W::SPLIT) * d,
                lower: (a & W::LOWER) * b - (c & W::LOWER) * d,
            }
        )
    }

    /// The sum without its lower part, so rounded down, and negative exactly if the
    /// sum is.
    #[inline(always)]
    fn sign(self) -> W {
        self.upper + (self.lower >> W::SPLIT)
    }
}
