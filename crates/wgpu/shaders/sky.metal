// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct BarchanTable {
    metal::float2 extent;
    metal::float2 spacing;
    float scale;
    float bias;
    uint transfer;
    uint edges;
    float first_azimuth;
    float azimuth_step;
    uint azimuths;
    uint is_circle;
    uint candidates;
    uint rings;
    uint ring_spacing;
    uint depth_mode;
    float max_tangent;
    float max_polar;
    float relief_top;
    float relief_thickness;
    uint first_level;
    uint levels;
    float least;
    float greatest;
};
struct BarchanTables {
    BarchanTable inner[12];
};
struct BarchanProbe {
    metal::float2 place;
    metal::float2 step;
    metal::packed_float3 light;
    float angular_radius;
    metal::packed_float3 eye;
    float level_distance;
    metal::packed_float3 first_form;
    float tolerance;
    metal::packed_float3 second_form;
    float unused_0_;
    metal::packed_float3 along_u;
    float unused_1_;
    metal::packed_float3 along_v;
    float unused_2_;
};
constant uint BARCHAN_SKY_VISIBILITY = 5u;

float barchan_arcsine(
    float sine
) {
    float size = metal::min(metal::abs(sine), 1.0);
    bool is_steep = size > 0.5;
    float square = is_steep ? (0.5 * (1.0 - size)) : (size * size);
    float root = is_steep ? metal::sqrt(square) : size;
    float series = ((((((((((0.0421632 * square) + 0.024181312) * square) + 0.045470025) * square) + 0.074953005) * square) + 0.16666752) * square) * root) + root;
    float angle_1 = is_steep ? (1.5707963 - (2.0 * series)) : series;
    return (sine < 0.0) ? -(angle_1) : angle_1;
}

float barchan_arctangent(
    float tangent
) {
    float start = 0.0;
    float part = {};
    float size_1 = metal::abs(tangent);
    part = size_1;
    if (size_1 > 2.4142137) {
        start = 1.5707964;
        part = -1.0 / size_1;
    } else {
        if (size_1 > 0.41421357) {
            start = 0.7853982;
            part = (size_1 - 1.0) / (size_1 + 1.0);
        }
    }
    float _e18 = part;
    float _e19 = part;
    float square_1 = _e18 * _e19;
    float _e21 = start;
    float _e33 = part;
    float _e35 = part;
    float angle_2 = _e21 + (((((((((0.080537446 * square_1) - 0.13877685) * square_1) + 0.19977711) * square_1) - 0.3333295) * square_1) * _e33) + _e35);
    return (tangent < 0.0) ? -(angle_2) : angle_2;
}

float barchan_azimuth(
    metal::float2 direction
) {
    metal::float2 size_2 = metal::abs(direction);
    float larger = metal::max(size_2.x, size_2.y);
    if (!((larger > 0.0))) {
        return 0.0;
    }
    float sine_1 = metal::min(size_2.x, size_2.y) / larger;
    float _e13 = barchan_arctangent(sine_1);
    float quadrant = (size_2.y > size_2.x) ? (1.5707964 - _e13) : _e13;
    float half_ = (direction.x < 0.0) ? (3.1415927 - quadrant) : quadrant;
    return (direction.y < 0.0) ? -(half_) : half_;
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

metal::float2 barchan_sine_cosine(
    float angle
) {
    bool local = {};
    float quarter = metal::rint(angle * 0.63661975);
    float rest = ((angle - (quarter * 1.5703125)) - (quarter * 0.0004837513)) - (quarter * 0.0000000754979);
    float square_2 = rest * rest;
    float sine_2 = ((((((-0.00019515296 * square_2) + 0.008332161) * square_2) - 0.16666655) * square_2) * rest) + rest;
    float cosine = (((((((0.000024433157 * square_2) - 0.0013887316) * square_2) + 0.041666646) * square_2) * square_2) - (0.5 * square_2)) + 1.0;
    int turned = naga_f2i32(quarter) & 3;
    metal::float2 swapped = ((turned & 1) != 0) ? metal::float2(cosine, sine_2) : metal::float2(sine_2, cosine);
    if (!((turned == 1))) {
        local = turned == 2;
    } else {
        local = true;
    }
    bool _e65 = local;
    return metal::float2((turned >= 2) ? -(swapped.x) : swapped.x, _e65 ? -(swapped.y) : swapped.y);
}

metal::int2 barchan_chosen(
    metal::int2 other,
    metal::int2 chosen,
    metal::bool2 is_chosen
) {
    return metal::int2(is_chosen.x ? chosen.x : other.x, is_chosen.y ? chosen.y : other.y);
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

metal::int2 naga_mod(metal::int2 lhs, metal::int2 rhs) {
    metal::int2 divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

metal::int2 barchan_inside(
    uint table,
    metal::int2 place,
    int level,
    constant BarchanTables& barchan_tables
) {
    uint first = barchan_tables.inner[table].first_level;
    metal::float2 _e10 = barchan_tables.inner[table].extent;
    metal::int2 whole = naga_f2i32(_e10);
    metal::int2 extent = metal::max(whole >> metal::uint2(first + static_cast<uint>(level)), metal::int2(1));
    uint edges = barchan_tables.inner[table].edges;
    metal::int2 repeated = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(naga_mod(place, extent)) + as_type<metal::uint2>(extent)), extent);
    metal::int2 clamped = metal::clamp(place, metal::int2(0), as_type<metal::int2>(as_type<metal::uint2>(extent) - as_type<metal::uint2>(metal::int2(1))));
    metal::int2 _e41 = barchan_chosen(clamped, repeated, metal::bool2((edges & 1u) != 0u, (edges & 2u) != 0u));
    return _e41;
}

float barchan_scaled(
    uint table_1,
    float stored,
    constant BarchanTables& barchan_tables
) {
    float _e5 = barchan_tables.inner[table_1].scale;
    float _e10 = barchan_tables.inner[table_1].bias;
    return (_e5 * stored) + _e10;
}

metal::float2 barchan_scaled_2_(
    uint table_2,
    metal::float2 stored_1,
    constant BarchanTables& barchan_tables
) {
    float _e5 = barchan_tables.inner[table_2].scale;
    float _e10 = barchan_tables.inner[table_2].bias;
    return (_e5 * stored_1) + metal::float2(_e10);
}

metal::float4 barchan_scaled_4_(
    uint table_3,
    metal::float4 stored_2,
    constant BarchanTables& barchan_tables
) {
    float _e5 = barchan_tables.inner[table_3].scale;
    float _e10 = barchan_tables.inner[table_3].bias;
    return (_e5 * stored_2) + metal::float4(_e10);
}

metal::float2 barchan_scaled_cone(
    uint table_4,
    metal::float2 stored_3,
    constant BarchanTables& barchan_tables
) {
    float _e4 = barchan_scaled(table_4, stored_3.y, barchan_tables);
    return metal::float2(stored_3.x, _e4);
}

float barchan_transferred(
    uint table_5,
    float number,
    constant BarchanTables& barchan_tables
) {
    uint _e5 = barchan_tables.inner[table_5].transfer;
    switch(_e5) {
        case 1u: {
            float _e6 = barchan_arcsine(number);
            return _e6;
        }
        case 2u: {
            return number * number;
        }
        default: {
            return number;
        }
    }
}

metal::float2 barchan_transferred_2_(
    uint table_6,
    metal::float2 number_1
) {
    return number_1;
}

metal::float4 barchan_transferred_4_(
    uint table_7,
    metal::float4 number_2
) {
    return number_2;
}

metal::float2 barchan_transferred_cone(
    uint table_8,
    metal::float2 number_3,
    constant BarchanTables& barchan_tables
) {
    float _e4 = barchan_transferred(table_8, number_3.y, barchan_tables);
    return metal::float2(number_3.x, _e4);
}

float barchan_sky_visibility_before_transfer(
    metal::int2 place_1,
    int layer,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_sky_visibility_texels
) {
    metal::int2 _e4 = barchan_inside(BARCHAN_SKY_VISIBILITY, place_1, 0, barchan_tables);
    metal::float4 _e7 = barchan_sky_visibility_texels.read(metal::uint2(_e4), layer);
    float _e9 = barchan_scaled(BARCHAN_SKY_VISIBILITY, _e7.x, barchan_tables);
    return _e9;
}

float barchan_sky_visibility_texel(
    metal::int2 place_2,
    int layer_1,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_sky_visibility_texels
) {
    float _e3 = barchan_sky_visibility_before_transfer(place_2, layer_1, barchan_tables, barchan_sky_visibility_texels);
    float _e4 = barchan_transferred(BARCHAN_SKY_VISIBILITY, _e3, barchan_tables);
    return _e4;
}

float barchan_sky_visibility_at(
    metal::float2 place_3,
    int layer_2,
    constant BarchanTables& barchan_tables,
    metal::sampler barchan_sampler,
    metal::texture2d<float, metal::access::sample> barchan_sky_visibility_texels
) {
    metal::float2 _e8 = barchan_tables.inner[5].extent;
    metal::float2 uv = (place_3 + metal::float2(0.5)) / _e8;
    metal::float4 _e13 = barchan_sky_visibility_texels.sample(barchan_sampler, uv, metal::level(0.0));
    float stored_4 = _e13.x;
    float _e17 = barchan_scaled(BARCHAN_SKY_VISIBILITY, stored_4, barchan_tables);
    float _e18 = barchan_transferred(BARCHAN_SKY_VISIBILITY, _e17, barchan_tables);
    return _e18;
}

float barchan_sky_brightness(
    metal::float2 place_4
) {
    return 1.0;
}

float barchan_sky_visibility(
    metal::float2 place_5,
    constant BarchanTables& barchan_tables,
    metal::sampler barchan_sampler,
    metal::texture2d<float, metal::access::sample> barchan_sky_visibility_texels
) {
    float _e2 = barchan_sky_visibility_at(place_5, 0, barchan_tables, barchan_sampler, barchan_sky_visibility_texels);
    return _e2;
}

float barchan_sky_irradiance(
    metal::float2 place_6,
    constant BarchanTables& barchan_tables,
    metal::sampler barchan_sampler,
    metal::texture2d<float, metal::access::sample> barchan_sky_visibility_texels
) {
    float _e1 = barchan_sky_visibility(place_6, barchan_tables, barchan_sampler, barchan_sky_visibility_texels);
    float _e2 = barchan_sky_brightness(place_6);
    return _e1 * _e2;
}

metal::float2 barchan_probe_place(
    metal::float4 position_1,
    constant BarchanProbe& barchan_probe
) {
    metal::float2 _e3 = barchan_probe.place;
    metal::float2 _e8 = barchan_probe.step;
    return _e3 + (metal::floor(position_1.xy) * _e8);
}

struct barchan_probe_vertexInput {
};
struct barchan_probe_vertexOutput {
    metal::float4 member [[position]];
};
vertex barchan_probe_vertexOutput barchan_probe_vertex(
  uint index [[vertex_id]]
) {
    return barchan_probe_vertexOutput { metal::float4((static_cast<float>(index & 1u) * 4.0) - 1.0, (static_cast<float>(index >> 1u) * 4.0) - 1.0, 0.0, 1.0) };
}


struct barchan_probe_skyInput {
};
struct barchan_probe_skyOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment barchan_probe_skyOutput barchan_probe_sky(
  metal::float4 position [[position]]
, constant BarchanTables& barchan_tables [[buffer(0)]]
, metal::sampler barchan_sampler [[sampler(1)]]
, metal::texture2d<float, metal::access::sample> barchan_sky_visibility_texels [[texture(7)]]
, constant BarchanProbe& barchan_probe [[buffer(14)]]
) {
    metal::float2 _e1 = barchan_probe_place(position, barchan_probe);
    float _e2 = barchan_sky_visibility(_e1, barchan_tables, barchan_sampler, barchan_sky_visibility_texels);
    float _e3 = barchan_sky_irradiance(_e1, barchan_tables, barchan_sampler, barchan_sky_visibility_texels);
    return barchan_probe_skyOutput { metal::float4(_e2, _e3, 0.0, 0.0) };
}
