//! Graphs z(x, y) over a square about the origin, x = (u − ½) size, y = (v − ½) size, front upwards: saddle, monkey saddle, wavy
//! sheet.
//!
//! Curvatures follow from the derivatives of z: the Gaussian one is (z_xx z_yy − z_xy²) / (1 + z_x² + z_y²)².

use std::f64::consts::TAU;

use glam::DVec3;

use super::SurfaceJet;

/// A height above (x, y) and its derivatives there.
struct Height {
    z: f64,
    x: f64,
    y: f64,
    xx: f64,
    xy: f64,
    yy: f64,
}

/// z = (x²/`valley_radius` − y²/`ridge_radius`) / 2. At the origin κ1 = 1/`ridge_radius`, κ2 = −1/`valley_radius`.
pub(super) fn saddle(valley_radius: f64, ridge_radius: f64, size: f64, u: f64, v: f64) -> SurfaceJet {
    over_square(size, u, v, |x, y| Height {
        z: 0.5 * (x * x / valley_radius - y * y / ridge_radius),
        x: x / valley_radius,
        y: -y / ridge_radius,
        xx: 1.0 / valley_radius,
        xy: 0.0,
        yy: -1.0 / ridge_radius,
    })
}

/// z = (x³ − 3 x y²) / `scale`². Flat to second order at the origin.
pub(super) fn monkey_saddle(scale: f64, size: f64, u: f64, v: f64) -> SurfaceJet {
    let strength = 1.0 / (scale * scale);
    over_square(size, u, v, |x, y| Height {
        z: strength * x * (x * x - 3.0 * y * y),
        x: strength * 3.0 * (x * x - y * y),
        y: strength * -6.0 * x * y,
        xx: strength * 6.0 * x,
        xy: strength * -6.0 * y,
        yy: strength * -6.0 * x,
    })
}

/// z = `amplitude` sin(k x) sin(k y), k = 2π / `wavelength`.
pub(super) fn wavy_sheet(amplitude: f64, wavelength: f64, size: f64, u: f64, v: f64) -> SurfaceJet {
    let k = TAU / wavelength;
    over_square(size, u, v, |x, y| {
        let (sin_x, cos_x) = (libm::sin(k * x), libm::cos(k * x));
        let (sin_y, cos_y) = (libm::sin(k * y), libm::cos(k * y));
        let z = amplitude * sin_x * sin_y;
        Height {
            z,
            x: amplitude * k * cos_x * sin_y,
            y: amplitude * k * sin_x * cos_y,
            xx: -k * k * z,
            xy: amplitude * k * k * cos_x * cos_y,
            yy: -k * k * z,
        }
    })
}

fn over_square(size: f64, u: f64, v: f64, height: impl Fn(f64, f64) -> Height) -> SurfaceJet {
    let (x, y) = ((u - 0.5) * size, (v - 0.5) * size);
    let h = height(x, y);
    SurfaceJet {
        position: DVec3::new(x, y, h.z),
        du: DVec3::new(1.0, 0.0, h.x) * size,
        dv: DVec3::new(0.0, 1.0, h.y) * size,
        duu: DVec3::Z * (h.xx * size * size),
        duv: DVec3::Z * (h.xy * size * size),
        dvv: DVec3::Z * (h.yy * size * size),
    }
}
