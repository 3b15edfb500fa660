// Functions of angles to a few ulp: of those built in, Vulkan promises 2⁻¹¹ for sines and 4096 ulp for arcs.
//
// Polynomials: Stephen Moshier, Cephes mathematical library, 1989.

// The angle of a sine. The arc of 1 is the f32 just below π/2, the greatest elevation of the format: that just above has a negative
// cosine, and would shade the zenith.
fn barchan_arcsine(sine: f32) -> f32 {
    let size = min(abs(sine), 1.0);
    // Beyond ½ the half-angle: asin s = π/2 − 2 asin √((1 − s) / 2).
    let is_steep = size > 0.5;
    let square = select(size * size, 0.5 * (1.0 - size), is_steep);
    let root = select(size, sqrt(square), is_steep);
    let series = ((((4.2163199048e-2 * square + 2.4181311049e-2) * square + 4.5470025998e-2) * square
        + 7.4953002686e-2) * square + 1.6666752422e-1) * square * root + root;
    let angle = select(series, 1.5707962513 - 2.0 * series, is_steep);
    return select(angle, -angle, sine < 0.0);
}

// The azimuth of a direction, in radians: 0 along +u, counter-clockwise.
fn barchan_azimuth(direction: vec2<f32>) -> f32 {
    let size = abs(direction);
    let larger = max(size.x, size.y);
    if !(larger > 0.0) {
        return 0.0;
    }
    let sine = min(size.x, size.y) / larger;
    let octant = barchan_arctangent(sine);
    let quadrant = select(octant, 1.5707963268 - octant, size.y > size.x);
    let half = select(quadrant, 3.1415926536 - quadrant, direction.x < 0.0);
    return select(half, -half, direction.y < 0.0);
}

// The angle of a tangent, within ±π/2.
fn barchan_arctangent(tangent: f32) -> f32 {
    let size = abs(tangent);
    var start = 0.0;
    var part = size;
    if size > 2.414213562 {
        start = 1.5707963268;
        part = -1.0 / size;
    } else if size > 0.4142135624 {
        start = 0.7853981634;
        part = (size - 1.0) / (size + 1.0);
    }
    let square = part * part;
    let angle = start + ((((8.05374449538e-2 * square - 1.38776856032e-1) * square + 1.99777106478e-1) * square
        - 3.33329491539e-1) * square * part + part);
    return select(angle, -angle, tangent < 0.0);
}

// The sine and the cosine of an angle within ±π.
fn barchan_sine_cosine(angle: f32) -> vec2<f32> {
    // To the nearest quarter turn, whose digits are taken off in three parts.
    let quarter = round(angle * 0.6366197724);
    let rest = ((angle - quarter * 1.5703125) - quarter * 4.837512969970703e-4) - quarter * 7.549789948768648e-8;
    let square = rest * rest;
    let sine = ((-1.9515295891e-4 * square + 8.3321608736e-3) * square - 1.6666654611e-1) * square * rest + rest;
    let cosine = ((2.443315711809948e-5 * square - 1.388731625493765e-3) * square + 4.166664568298827e-2) * square * square
        - 0.5 * square + 1.0;
    let turned = i32(quarter) & 3;
    let swapped = select(vec2<f32>(sine, cosine), vec2<f32>(cosine, sine), (turned & 1) != 0);
    return vec2<f32>(
        select(swapped.x, -swapped.x, turned >= 2),
        select(swapped.y, -swapped.y, turned == 1 || turned == 2),
    );
}
