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
struct BarchanNeighbours {
    int first;
    int second;
    float weight;
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
constant uint BARCHAN_HORIZON = 1u;
constant float BARCHAN_TURN = 6.2831855;

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

float barchan_horizon_before_transfer(
    metal::int2 place_1,
    int layer,
    constant BarchanTables& barchan_tables,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels
) {
    metal::int2 _e4 = barchan_inside(BARCHAN_HORIZON, place_1, 0, barchan_tables);
    metal::float4 _e8 = barchan_horizon_texels.read(metal::uint2(_e4), layer, 0);
    float _e10 = barchan_scaled(BARCHAN_HORIZON, _e8.x, barchan_tables);
    return _e10;
}

float barchan_horizon_texel(
    metal::int2 place_2,
    int layer_1,
    constant BarchanTables& barchan_tables,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels
) {
    float _e3 = barchan_horizon_before_transfer(place_2, layer_1, barchan_tables, barchan_horizon_texels);
    float _e4 = barchan_transferred(BARCHAN_HORIZON, _e3, barchan_tables);
    return _e4;
}

float barchan_horizon_at(
    metal::float2 place_3,
    int layer_2,
    constant BarchanTables& barchan_tables,
    metal::sampler barchan_sampler,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels
) {
    metal::float2 _e8 = barchan_tables.inner[1].extent;
    metal::float2 uv = (place_3 + metal::float2(0.5)) / _e8;
    metal::float4 _e13 = barchan_horizon_texels.sample(barchan_sampler, uv, layer_2, metal::level(0.0));
    float stored_4 = _e13.x;
    float _e17 = barchan_scaled(BARCHAN_HORIZON, stored_4, barchan_tables);
    float _e18 = barchan_transferred(BARCHAN_HORIZON, _e17, barchan_tables);
    return _e18;
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

BarchanNeighbours barchan_neighbours(
    uint table_9,
    float azimuth,
    constant BarchanTables& barchan_tables
) {
    bool local_1 = {};
    uint _e5 = barchan_tables.inner[table_9].azimuths;
    int count = static_cast<int>(_e5);
    float step = barchan_tables.inner[table_9].azimuth_step;
    float _e14 = barchan_tables.inner[table_9].first_azimuth;
    float turns = (azimuth - _e14) / BARCHAN_TURN;
    float offset = (turns - metal::floor(turns)) * BARCHAN_TURN;
    if (!((count <= 1))) {
        local_1 = step <= 0.0;
    } else {
        local_1 = true;
    }
    bool _e30 = local_1;
    if (_e30) {
        return BarchanNeighbours {0, 0, 0.0};
    }
    float position_2 = offset / step;
    float index_1 = metal::floor(position_2);
    float weight = position_2 - index_1;
    uint _e41 = barchan_tables.inner[table_9].is_circle;
    if (_e41 != 0u) {
        int first_1 = naga_mod(naga_f2i32(index_1), count);
        return BarchanNeighbours {first_1, naga_mod(as_type<int>(as_type<uint>(first_1) + as_type<uint>(1)), count), weight};
    }
    int last = as_type<int>(as_type<uint>(count) - as_type<uint>(1));
    float span = static_cast<float>(last) * step;
    if (offset < span) {
        int first_2 = metal::min(naga_f2i32(index_1), as_type<int>(as_type<uint>(last) - as_type<uint>(1)));
        return BarchanNeighbours {first_2, as_type<int>(as_type<uint>(first_2) + as_type<uint>(1)), metal::min(position_2 - static_cast<float>(first_2), 1.0)};
    }
    int end = ((BARCHAN_TURN - offset) <= (offset - span)) ? 0 : last;
    return BarchanNeighbours {end, end, 0.0};
}

float barchan_horizon_elevation(
    metal::float2 place_4,
    float azimuth_1,
    constant BarchanTables& barchan_tables,
    metal::sampler barchan_sampler,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels
) {
    BarchanNeighbours _e3 = barchan_neighbours(BARCHAN_HORIZON, azimuth_1, barchan_tables);
    float _e5 = barchan_horizon_at(place_4, _e3.first, barchan_tables, barchan_sampler, barchan_horizon_texels);
    float _e7 = barchan_horizon_at(place_4, _e3.second, barchan_tables, barchan_sampler, barchan_horizon_texels);
    return metal::mix(_e5, _e7, _e3.weight);
}

bool barchan_horizon_in_shadow(
    metal::float2 place_5,
    metal::float3 towards,
    constant BarchanTables& barchan_tables,
    metal::sampler barchan_sampler,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels
) {
    float _e3 = barchan_azimuth(towards.xy);
    float _e4 = barchan_horizon_elevation(place_5, _e3, barchan_tables, barchan_sampler, barchan_horizon_texels);
    metal::float2 _e5 = barchan_sine_cosine(_e4);
    return (towards.z * _e5.y) < (metal::length(towards.xy) * _e5.x);
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


struct barchan_probe_horizonInput {
};
struct barchan_probe_horizonOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment barchan_probe_horizonOutput barchan_probe_horizon(
  metal::float4 position [[position]]
, constant BarchanTables& barchan_tables [[buffer(0)]]
, metal::sampler barchan_sampler [[sampler(1)]]
, metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels [[texture(3)]]
, constant BarchanProbe& barchan_probe [[buffer(14)]]
) {
    metal::float2 _e1 = barchan_probe_place(position, barchan_probe);
    metal::float3 _e4 = barchan_probe.light;
    float _e6 = barchan_azimuth(_e4.xy);
    float _e7 = barchan_horizon_elevation(_e1, _e6, barchan_tables, barchan_sampler, barchan_horizon_texels);
    metal::float3 _e10 = barchan_probe.light;
    bool _e11 = barchan_horizon_in_shadow(_e1, _e10, barchan_tables, barchan_sampler, barchan_horizon_texels);
    return barchan_probe_horizonOutput { metal::float4(_e7, _e11 ? 1.0 : 0.0, 0.0, 0.0) };
}
