// The plane z = 0, u along x and v along y.
fn picture_hit(origin: vec3<f32>, towards: vec3<f32>) -> PictureHit {
    let position = origin - towards * (origin.z / towards.z);
    let along_u = vec3<f32>(picture_view.tile.x, 0.0, 0.0);
    let along_v = vec3<f32>(0.0, picture_view.tile.y, 0.0);
    let is_hit = towards.z > 0.0;
    return PictureHit(position.xy / picture_view.tile, along_u, along_v, vec3<f32>(0.0, 0.0, 1.0), is_hit);
}
