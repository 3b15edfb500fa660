//! Scratch.
use barchan_bakers::{Exec, curvature::*};
use barchan_field::surfaces::*;
use std::time::Instant;
fn main() {
    let n: u32 = std::env::args().nth(1).map_or(4000, |a| a.parse().unwrap());
    let noise: f64 = std::env::args().nth(2).map_or(0.0, |a| a.parse().unwrap());
    let method = if std::env::args().nth(3).as_deref() == Some("fast") {
        CurvatureMethod::Fast
    } else {
        CurvatureMethod::Accurate
    };
    let list = ParametricSurface::examples();
    let only = std::env::var("ONLY").unwrap_or_default();
    let pats = std::env::var("PAT").unwrap_or_default();
    for s in list {
        if !s.name().contains(&only) {
            continue;
        }
        for pattern in
            [Pattern::Regular { aspect: 1.0 }, Pattern::Jittered, Pattern::Random, Pattern::LongThin { aspect: 20.0 }]
        {
            if !format!("{pattern:?}").contains(&pats) {
                continue;
            }
            run(&s, n, pattern, noise, method);
        }
    }
}
fn run(s: &ParametricSurface, n: u32, pattern: Pattern, noise: f64, method: CurvatureMethod) {
    let t = s.tessellate(&Tessellation { vertices: n, pattern, seed: 3, uv_seam: false }).unwrap();
    let mut mesh = t.mesh.clone();
    let exec = Exec::new(1).unwrap();
    if n > 100_000 {
        let t0 = busy();
        let c = bake(&mesh, &CurvatureParams { method: CurvatureMethod::Fast, ..Default::default() }, &exec).unwrap();
        println!("fast {} {:.2} M/s", c.vertices.len(), c.vertices.len() as f64 / (busy() - t0) / 1e6);
    }
    let p = CurvatureParams { method, ..Default::default() };
    let edge = bake(&mesh, &p, &exec).unwrap().report.mean_edge;
    if noise > 0.0 {
        mesh = with_vertex_noise(&mesh, noise * edge, 5).unwrap();
    }
    let cpu = || std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    let _ = cpu;
    let start = Instant::now();
    let before = busy();
    let c = bake(&mesh, &p, &exec).unwrap();
    let _ = start;
    let took = busy() - before;
    let (mut sum, mut top, mut max, mut flags, mut scale) = (0.0, 0, 0.0_f64, 0, 0.0);
    let (mut ang, mut angs) = (0.0, 0);
    let mut worst = 0;
    let (mut isum, mut icount) = (0.0, 0);
    for (i, (uv, v)) in t.parameters.iter().zip(&c.vertices).enumerate() {
        let truth = s.jet(uv.x, uv.y).curvature();
        let k = truth.principal;
        let big = k[0].abs().max(k[1].abs());
        scale += big * big;
        let inner = !v.flags.contains(barchan_asset::VertexFlags::BOUNDARY);
        if inner {
            isum += (v.principal[0] - k[0]).powi(2) + (v.principal[1] - k[1]).powi(2);
            icount += 2;
        }
        for j in 0..2 {
            let e = v.principal[j] - k[j];
            if e.abs() > max {
                worst = i;
            }
            max = max.max(e.abs());
            sum += e * e;
        }
        if (k[0] - k[1]).abs() > 0.1 * big {
            let d = v.directions[0].dot(truth.directions[0]).abs().min(1.0);
            let a = d.acos();
            ang += a * a;
            angs += 1;
        }
        if v.flags.0 != 0 {
            flags += 1;
        }
        top += 1;
    }
    let scale = (scale / top as f64).sqrt();
    println!(
        "{:10} {:24} {:6} edge {:.4} rms {:.2e} inner {:.2e} max {:.2e} ({:?}) dir {:.4}° flags {} {:.2} M/s noise {:.3}",
        s.name(),
        format!("{pattern:?}"),
        top,
        edge,
        (sum / (2 * top) as f64).sqrt() / scale,
        (isum / icount as f64).sqrt() / scale,
        max / scale,
        c.vertices[worst].flags,
        (ang / f64::from(angs.max(1))).sqrt().to_degrees(),
        flags,
        top as f64 / took / 1e6,
        c.noise / edge
    );
}

fn busy() -> f64 {
    let mut total = 0.0;
    for task in std::fs::read_dir("/proc/self/task").unwrap() {
        let text = std::fs::read_to_string(task.unwrap().path().join("schedstat")).unwrap_or_default();
        total += text.split(' ').next().and_then(|n| n.parse::<f64>().ok()).unwrap_or(0.0) * 1e-9;
    }
    total
}
