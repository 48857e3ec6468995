use super::MeshError;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle, Vec3, joined};

/// Indexed triangles in the caller's memory: a slice of vertices and a slice of triangles.
///
/// Every vertex is finite and every index is in range; the constructors check this. A triangle may
/// be a segment or a point. Vertices may coincide, and may belong to no triangle.
///
/// Copying a `Mesh` copies two references, not the data.
///
/// ```
/// use septum::Vec3;
/// use septum::mesh::{Mesh, MeshError};
///
/// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Vec3::from);
/// let mesh = Mesh::new(&vertices, &[[0_u16, 1, 2]])?;
/// assert_eq!(mesh.triangle(0).unwrap().vertices(), &vertices);
/// assert_eq!(mesh.aabb(), Some(mesh.triangle(0).unwrap().aabb()));
///
/// let bad = Mesh::new(&vertices, &[[0_u16, 1, 2], [0, 1, 3]]);
/// assert_eq!(bad, Err(MeshError::NoSuchVertex { triangle: 1 }));
/// # Ok::<(), MeshError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh<'a, S, I> {
    pub(super) vertices: &'a [Vec3<S>],
    pub(super) triangles: &'a [[I; 3]],
}

impl<'a, S: Scalar, I: Index> Mesh<'a, S, I> {
    /// A mesh of these vertices and triangles.
    ///
    /// # Errors
    /// [`MeshError::NotFinite`], [`MeshError::NoSuchVertex`], and [`MeshError::TooManyTriangles`]
    /// if `I` has fewer values than there are triangles.
    pub fn new(vertices: &'a [Vec3<S>], triangles: &'a [[I; 3]]) -> Result<Self, MeshError> {
        if let Some(vertex) = vertices.iter().position(|v| !v.is_finite()) {
            return Err(MeshError::NotFinite { vertex });
        }
        let is_there = |t: &[I; 3]| t.iter().all(|i| i.get() < vertices.len());
        if let Some(triangle) = triangles.iter().position(|t| !is_there(t)) {
            return Err(MeshError::NoSuchVertex { triangle });
        }
        if triangles.len() as u64 > I::COUNT {
            return Err(MeshError::TooManyTriangles);
        }
        Ok(Self { vertices, triangles })
    }

    /// The triangle with this index, if there is one.
    #[inline]
    #[must_use]
    pub fn triangle(&self, i: usize) -> Option<Triangle<S>> {
        self.triangles.get(i).map(|corners| self.at(corners))
    }

    /// All triangles, in the order of their indices.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Triangle<S>> + 'a {
        let this = *self;
        self.triangles.iter().map(move |corners| this.at(corners))
    }

    /// The bounding box of all triangles: the smallest axis-aligned box that contains them. Exact.
    /// `None` if there are no triangles.
    ///
    /// Vertices that belong to no triangle do not count.
    #[doc(alias = "bounding box")]
    #[must_use]
    pub fn aabb(&self) -> Option<Aabb<S>> {
        let [min, max] = self.iter().map(|t| t.corners()).reduce(joined)?;
        Some(Aabb::between(min.into(), max.into()))
    }

    #[inline(always)]
    fn at(&self, corners: &[I; 3]) -> Triangle<S> {
        // `new` made sure of the indices; `unwrap_or` links no panic.
        let vertex = |i: I| self.vertices.get(i.get()).copied().unwrap_or(Vec3::splat(S::ZERO));
        Triangle::unchecked([vertex(corners[0]), vertex(corners[1]), vertex(corners[2])])
    }

    /// The triangle with an index that is known to be in range.
    #[inline(always)]
    pub(crate) fn known(&self, i: usize) -> Triangle<S> {
        self.triangle(i).unwrap_or(Triangle::unchecked([Vec3::splat(S::ZERO); 3]))
    }
}

impl<'a, S, I> Mesh<'a, S, I> {
    /// The vertices.
    #[inline]
    #[must_use]
    pub const fn vertices(&self) -> &'a [Vec3<S>] {
        self.vertices
    }

    /// The triangles, as indices of vertices.
    #[inline]
    #[must_use]
    pub const fn triangles(&self) -> &'a [[I; 3]] {
        self.triangles
    }
}

/// An index of a vertex or a triangle: `u16`, which saves flash, or `u32`.
///
/// The trait is sealed.
pub trait Index: sealed::Sealed + Copy + Ord + core::fmt::Debug + Send + Sync + 'static {
    /// The number of different indices.
    #[doc(hidden)]
    const COUNT: u64;
    #[doc(hidden)]
    fn get(self) -> usize;
    /// The index `i`, which is below [`COUNT`](Self::COUNT).
    #[doc(hidden)]
    fn of(i: usize) -> Self;
}

impl Index for u16 {
    const COUNT: u64 = 1 << 16;

    #[inline(always)]
    fn get(self) -> usize {
        self.into()
    }

    #[inline(always)]
    fn of(i: usize) -> Self {
        i as Self
    }
}

impl Index for u32 {
    const COUNT: u64 = 1 << 32;

    #[inline(always)]
    fn get(self) -> usize {
        self as usize
    }

    #[inline(always)]
    fn of(i: usize) -> Self {
        i as Self
    }
}

mod sealed {
    pub trait Sealed {}

    impl Sealed for u16 {}
    impl Sealed for u32 {}
}
