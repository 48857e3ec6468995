//! The rows of the table: one for each query.

macro_rules! queries {
    ($($query:ident = $row:literal,)*) => {
        /// A query whose answers are hashed.
        #[derive(Clone, Copy)]
        pub(crate) enum Query {
            $($query,)*
        }

        /// The names of the rows, in the order of the queries. A name stays when the method
        /// that it stands for is renamed.
        pub(crate) const ROWS: [&str; [$($row),*].len()] = [$($row),*];
    };
}

queries! {
    ShapesAccepted = "shapes accepted",
    TriangleAabb = "triangle/aabb overlaps",
    TriangleAabbMay = "triangle/aabb may_overlap",
    TriangleAabbAxis = "triangle/aabb separating_axis",
    TriangleAabbBy = "triangle/aabb is_separated_by",
    TriangleAabbRounded = "triangle/aabb rounded",
    TriangleAabbPublished = "triangle/aabb published",
    TriangleAabbOrders = "triangle/aabb published orders",
    TriangleObb = "triangle/obb overlaps",
    TriangleObbMay = "triangle/obb may_overlap",
    TriangleObbTransform = "triangle/obb by_transform",
    TriangleDegenerate = "triangle is_degenerate",
    TriangleNormal = "triangle unit_normal",
    PlaneAabb = "plane/aabb overlaps",
    PlaneAabbSide = "plane/aabb side_of",
    SegmentAabb = "segment/aabb overlaps",
    SegmentAabbMay = "segment/aabb may_overlap",
    SegmentAabbPublished = "segment/aabb published",
    RayAabb = "ray/aabb overlaps",
    RayAabbMay = "ray/aabb may_overlap",
    RayAabbRange = "ray/aabb t_range",
    RayAabbLimited = "ray/aabb t_range limited",
    RayAabbPublished = "ray/aabb published",
    RayAabbSlabs = "ray/aabb slabs",
    RayAabbSlabsRange = "ray/aabb slabs t_range",
    RayAabbSlabsMay = "ray/aabb slabs may_overlap",
    RayAabbSlopes = "ray/aabb slopes",
    RayAabbSlopesEnter = "ray/aabb slopes t_enter",
    RayTriangle = "ray/triangle hit",
    RayTriangleOnce = "ray/triangle hit_once",
    RayTriangleIs = "ray/triangle is_hit",
    RayTriangleRules = "ray/triangle hit_with",
    RayTriangleIsRules = "ray/triangle is_hit_with",
    RayTriangleLimited = "ray/triangle hit limited",
    RayTriangleMollerTrumbore = "ray/triangle moller_trumbore",
    RayTriangleVolumes = "ray/triangle volumes",
    RayTriangleStored = "ray/triangle stored_normal",
    RayTriangleStoredT = "ray/triangle stored_normal t",
    RayTriangleProjected = "ray/triangle projected",
    RayTriangleWatertight = "ray/triangle watertight",
    RayTriangles = "ray/4 triangles hit",
    RayTrianglesMollerTrumbore = "ray/4 triangles moller_trumbore",
    RayTrianglesVolumes = "ray/4 triangles volumes",
    RayTrianglesStored = "ray/4 triangles stored_normal",
    RayTrianglesWatertight = "ray/4 triangles watertight",
    RaysTriangleMollerTrumbore = "4 rays/triangle moller_trumbore",
    RaysTriangleVolumes = "4 rays/triangle volumes",
    RaysTriangleStored = "4 rays/triangle stored_normal",
    RaysAabbSlabs = "4 rays/aabb slabs t_range",
    RayAabbsSlabs = "ray/4 aabbs slabs t_range",
    AabbAabb = "aabb/aabb overlaps",
    AabbContains = "aabb contains",
    ObbContains = "obb contains",
    ObbAabb = "obb aabb",
    AxisVector = "axis vector",
    RayCompareHits = "ray compare_hits",
    RayAabbPrepared = "ray/aabb prepared",
    TriangleAabbPrepared = "triangle/aabb prepared",
    GridAccepted = "grid accepted",
    GridRowsClosed = "grid/triangle closed",
    GridRowsHalfOpen = "grid/triangle half-open",
    GridRowsThin = "grid/triangle thin",
    GridCrossings = "grid/triangle crossings",
    GridWalkSegment = "grid/segment walk",
    GridWalkRay = "grid/ray walk",
}
