// Where a ray meets the relief, by the start and the search of this shader.

// The top plane for a ray that is not valid.
fn barchan_relief_find(ray: BarchanReliefRay) -> BarchanFound {
    if !ray.is_valid {
        return BarchanFound(0.0, vec2<i32>(0));
    }
    return barchan_relief_search(ray, barchan_relief_start(ray));
}
