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
struct BarchanTangentLight {
    float height;
    float level;
    metal::float2 direction;
    float azimuth;
    float stretch;
};
struct BarchanGradients {
    metal::float3 of_u;
    metal::float3 of_v;
};
struct BarchanReliefRay {
    metal::float2 place;
    metal::float2 step;
    metal::packed_float3 towards;
    float tangent;
    bool is_valid;
    char _pad5[15];
};
struct BarchanStart {
    float depth;
    bool is_proven;
    char _pad2[3];
    metal::int2 fetches;
};
struct BarchanFound {
    float depth;
    char _pad1[4];
    metal::int2 fetches;
};
struct BarchanReliefExit {
    float depth;
    char _pad1[4];
    metal::int2 next;
};
struct BarchanReliefLeft {
    float outside;
    float inside;
    bool is_within;
    char _pad3[3];
    int fetches;
};
struct BarchanMipBlock {
    metal::int2 low;
    metal::int2 high;
    metal::int2 texel;
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
constant uint BARCHAN_HEIGHT = 0u;
constant uint BARCHAN_MAXIMUM_MIP = 11u;
constant float BARCHAN_LONGEST_WAY = 65536.0;
constant float BARCHAN_FARTHEST = 16777216.0;
constant float BARCHAN_STEEPEST = 1048576.0;
constant int BARCHAN_MOST_TURNS = 4096;
constant float BARCHAN_STEP_BACK = 0.015625;
constant int BARCHAN_ENDLESS = 33554432;
constant float BARCHAN_LONGEST_BLOCK = 4.0;

float barchan_arcsine(
    float sine
) {
    float size_1 = metal::min(metal::abs(sine), 1.0);
    bool is_steep = size_1 > 0.5;
    float square = is_steep ? (0.5 * (1.0 - size_1)) : (size_1 * size_1);
    float root = is_steep ? metal::sqrt(square) : size_1;
    float series = ((((((((((0.0421632 * square) + 0.024181312) * square) + 0.045470025) * square) + 0.074953005) * square) + 0.16666752) * square) * root) + root;
    float angle_1 = is_steep ? (1.5707963 - (2.0 * series)) : series;
    return (sine < 0.0) ? -(angle_1) : angle_1;
}

float barchan_arctangent(
    float tangent
) {
    float start = 0.0;
    float part = {};
    float size_2 = metal::abs(tangent);
    part = size_2;
    if (size_2 > 2.4142137) {
        start = 1.5707964;
        part = -1.0 / size_2;
    } else {
        if (size_2 > 0.41421357) {
            start = 0.7853982;
            part = (size_2 - 1.0) / (size_2 + 1.0);
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
    metal::float2 size_3 = metal::abs(direction);
    float larger = metal::max(size_3.x, size_3.y);
    if (!((larger > 0.0))) {
        return 0.0;
    }
    float sine_1 = metal::min(size_3.x, size_3.y) / larger;
    float _e13 = barchan_arctangent(sine_1);
    float quadrant = (size_3.y > size_3.x) ? (1.5707964 - _e13) : _e13;
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
    metal::int2 extent_1 = metal::max(whole >> metal::uint2(first + static_cast<uint>(level)), metal::int2(1));
    uint edges = barchan_tables.inner[table].edges;
    metal::int2 repeated = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(naga_mod(place, extent_1)) + as_type<metal::uint2>(extent_1)), extent_1);
    metal::int2 clamped = metal::clamp(place, metal::int2(0), as_type<metal::int2>(as_type<metal::uint2>(extent_1) - as_type<metal::uint2>(metal::int2(1))));
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

float barchan_height_before_transfer(
    metal::int2 place_1,
    int layer,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels
) {
    metal::int2 _e4 = barchan_inside(BARCHAN_HEIGHT, place_1, 0, barchan_tables);
    metal::float4 _e7 = barchan_height_texels.read(metal::uint2(_e4), layer);
    float _e9 = barchan_scaled(BARCHAN_HEIGHT, _e7.x, barchan_tables);
    return _e9;
}

float barchan_height_texel(
    metal::int2 place_2,
    int layer_1,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels
) {
    float _e3 = barchan_height_before_transfer(place_2, layer_1, barchan_tables, barchan_height_texels);
    float _e4 = barchan_transferred(BARCHAN_HEIGHT, _e3, barchan_tables);
    return _e4;
}

float barchan_maximum_mip_before_transfer(
    metal::int2 place_3,
    int layer_2,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_maximum_mip_texels
) {
    metal::int2 _e3 = barchan_inside(BARCHAN_MAXIMUM_MIP, place_3, layer_2, barchan_tables);
    metal::float4 _e6 = barchan_maximum_mip_texels.read(metal::uint2(_e3), layer_2);
    float _e8 = barchan_scaled(BARCHAN_MAXIMUM_MIP, _e6.x, barchan_tables);
    return _e8;
}

float barchan_maximum_mip_texel(
    metal::int2 place_4,
    int layer_3,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_maximum_mip_texels
) {
    float _e3 = barchan_maximum_mip_before_transfer(place_4, layer_3, barchan_tables, barchan_maximum_mip_texels);
    float _e4 = barchan_transferred(BARCHAN_MAXIMUM_MIP, _e3, barchan_tables);
    return _e4;
}

BarchanGradients barchan_gradients(
    metal::float3 along_u,
    metal::float3 along_v
) {
    metal::float3 area = metal::cross(along_u, along_v);
    float area_squared = metal::dot(area, area);
    if (!((area_squared > 0.0))) {
        return BarchanGradients {metal::float3(0.0), metal::float3(0.0)};
    }
    return BarchanGradients {metal::cross(along_v, area) / metal::float3(area_squared), metal::cross(area, along_u) / metal::float3(area_squared)};
}

metal::float2 barchan_texture_step(
    metal::float3 along_u_1,
    metal::float3 along_v_1,
    metal::float3 vector
) {
    BarchanGradients _e3 = barchan_gradients(along_u_1, along_v_1);
    return metal::float2(metal::dot(vector, _e3.of_u), metal::dot(vector, _e3.of_v));
}

metal::float3 barchan_bump_normal(
    metal::float3 along_u_2,
    metal::float3 along_v_2,
    metal::float3 normal,
    metal::float2 per_uv
) {
    BarchanGradients _e4 = barchan_gradients(along_u_2, along_v_2);
    return metal::normalize((normal - (per_uv.x * _e4.of_u)) - (per_uv.y * _e4.of_v));
}

BarchanTangentLight barchan_tangent_light(
    metal::float3 along_u_3,
    metal::float3 along_v_3,
    metal::float3 normal_1,
    metal::float3 towards,
    metal::float2 extent
) {
    bool local_1 = {};
    float height_1 = metal::dot(towards, normal_1);
    metal::float3 tangent_1 = towards - (normal_1 * height_1);
    float level_6 = metal::length(tangent_1);
    metal::float2 _e9 = barchan_texture_step(along_u_3, along_v_3, tangent_1);
    metal::float2 on_grid = _e9 * extent;
    float grid_length = metal::length(on_grid);
    if (level_6 > 0.0) {
        local_1 = grid_length > 0.0;
    } else {
        local_1 = false;
    }
    bool _e19 = local_1;
    if (!(_e19)) {
        return BarchanTangentLight {height_1, level_6, _e9, 0.0, 1.0};
    }
    float _e24 = barchan_azimuth(on_grid);
    return BarchanTangentLight {height_1, level_6, _e9, _e24, level_6 / grid_length};
}

float barchan_relief_thickness(
    constant BarchanTables& barchan_tables
) {
    float _e3 = barchan_tables.inner[0].greatest;
    float _e7 = barchan_tables.inner[0].least;
    return _e3 - _e7;
}

metal::float4 barchan_relief_depths(
    metal::float4 heights,
    constant BarchanTables& barchan_tables
) {
    float _e1 = barchan_relief_thickness(barchan_tables);
    if (!((_e1 > 0.0))) {
        return metal::float4(0.0);
    }
    float _e10 = barchan_tables.inner[0].greatest;
    return (metal::float4(_e10) - heights) / metal::float4(_e1);
}

float barchan_relief_depth(
    float height,
    constant BarchanTables& barchan_tables
) {
    metal::float4 _e2 = barchan_relief_depths(metal::float4(height), barchan_tables);
    return _e2.x;
}

metal::float2 barchan_relief_in_tile(
    metal::float2 place_5,
    constant BarchanTables& barchan_tables
) {
    metal::float2 extent_2 = barchan_tables.inner[0].extent;
    uint edges_1 = barchan_tables.inner[0].edges;
    metal::bool2 repeats_1 = metal::bool2((edges_1 & 1u) != 0u, (edges_1 & 2u) != 0u);
    metal::float2 rest_1 = place_5 - (metal::floor(place_5 / extent_2) * extent_2);
    return metal::select(place_5, metal::select(rest_1, rest_1 + extent_2, rest_1 < metal::float2(0.0)), repeats_1);
}

BarchanReliefRay barchan_relief_ray(
    metal::float2 place_6,
    metal::float3 towards_1,
    constant BarchanTables& barchan_tables
) {
    bool local_2 = {};
    bool local_3 = {};
    bool local_4 = {};
    metal::float2 spacing = barchan_tables.inner[0].spacing;
    float _e6 = barchan_relief_thickness(barchan_tables);
    float thickness = metal::max(_e6, 0.0);
    float level_7 = metal::length(towards_1.xy);
    float way_1 = thickness * ((metal::abs(towards_1.x) * spacing.y) + (metal::abs(towards_1.y) * spacing.x));
    if (way_1 <= (((BARCHAN_LONGEST_WAY * spacing.x) * spacing.y) * towards_1.z)) {
        local_2 = level_7 <= (BARCHAN_STEEPEST * towards_1.z);
    } else {
        local_2 = false;
    }
    bool is_short = local_2;
    bool is_near = metal::all(metal::abs(place_6) <= metal::float2(16777216.0));
    if (towards_1.z > 0.0) {
        local_3 = is_short;
    } else {
        local_3 = false;
    }
    bool _e48 = local_3;
    if (_e48) {
        local_4 = is_near;
    } else {
        local_4 = false;
    }
    bool _e52 = local_4;
    if (!(_e52)) {
        return BarchanReliefRay {metal::float2(0.0), metal::float2(0.0), metal::float3(0.0, 0.0, 1.0), 0.0, false};
    }
    float run = thickness / towards_1.z;
    metal::float2 step_1 = metal::float2(-(run) * towards_1.x, run * towards_1.y) / spacing;
    metal::float2 _e74 = barchan_relief_in_tile(place_6, barchan_tables);
    return BarchanReliefRay {_e74, step_1, towards_1, level_7 / towards_1.z, true};
}

BarchanReliefRay barchan_relief_ray_through(
    metal::float2 place_7,
    float depth,
    metal::float3 towards_2,
    constant BarchanTables& barchan_tables
) {
    BarchanReliefRay _e3 = barchan_relief_ray(place_7, towards_2, barchan_tables);
    if (!(_e3.is_valid)) {
        return _e3;
    }
    BarchanReliefRay _e10 = barchan_relief_ray(_e3.place - (depth * _e3.step), towards_2, barchan_tables);
    return _e10;
}

metal::float2 barchan_relief_at(
    BarchanReliefRay ray,
    float depth_1
) {
    return ray.place + (depth_1 * ray.step);
}

float barchan_relief_way(
    BarchanReliefRay ray_1
) {
    return metal::max(metal::abs(ray_1.step.x), metal::abs(ray_1.step.y));
}

float barchan_relief_way_ahead(
    BarchanReliefRay ray_2,
    float start_1
) {
    float _e7 = barchan_relief_way(ray_2);
    return ((start_1 > 0.0) ? 0.03125 : 0.25) * _e7;
}

metal::int2 barchan_relief_cell(
    BarchanReliefRay ray_3,
    float depth_2
) {
    metal::float2 _e2 = barchan_relief_at(ray_3, depth_2);
    return naga_f2i32(metal::select(metal::floor(_e2), metal::ceil(_e2) - metal::float2(1.0), ray_3.step < metal::float2(0.0)));
}

metal::int2 barchan_relief_cell_of(
    BarchanReliefRay ray_4,
    metal::int2 low,
    metal::int2 high,
    float depth_3
) {
    metal::int2 _e4 = barchan_relief_cell(ray_4, depth_3);
    return metal::clamp(_e4, low, as_type<metal::int2>(as_type<metal::uint2>(high) - as_type<metal::uint2>(metal::int2(1))));
}

BarchanReliefExit barchan_relief_exit(
    BarchanReliefRay ray_5,
    metal::int2 low_1,
    metal::int2 high_1,
    float start_2
) {
    metal::int2 next = {};
    metal::bool2 moves = ray_5.step != metal::float2(0.0);
    metal::int2 _e12 = barchan_chosen(low_1, high_1, ray_5.step > metal::float2(0.0));
    metal::float2 ends = static_cast<metal::float2>(_e12);
    metal::float2 borders = metal::select(metal::float2(1000000000000000000000000000000.0), (ends - ray_5.place) / metal::select(metal::float2(1.0), ray_5.step, moves), moves);
    float depth_8 = metal::min(metal::max(metal::min(borders.x, borders.y), start_2), 1.0);
    metal::int2 _e30 = barchan_relief_cell_of(ray_5, low_1, high_1, depth_8);
    next = _e30;
    metal::int2 _e39 = barchan_chosen(high_1, as_type<metal::int2>(as_type<metal::uint2>(low_1) - as_type<metal::uint2>(metal::int2(1))), ray_5.step < metal::float2(0.0));
    if (borders.x <= borders.y) {
        next.x = _e39.x;
    } else {
        next.y = _e39.y;
    }
    metal::int2 _e47 = next;
    return BarchanReliefExit {depth_8, {}, _e47};
}

metal::float4 barchan_relief_corners(
    metal::int2 cell,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels
) {
    float _e2 = barchan_height_texel(cell, 0, barchan_tables, barchan_height_texels);
    float _e8 = barchan_height_texel(as_type<metal::int2>(as_type<metal::uint2>(cell) + as_type<metal::uint2>(metal::int2(1, 0))), 0, barchan_tables, barchan_height_texels);
    float _e14 = barchan_height_texel(as_type<metal::int2>(as_type<metal::uint2>(cell) + as_type<metal::uint2>(metal::int2(0, 1))), 0, barchan_tables, barchan_height_texels);
    float _e20 = barchan_height_texel(as_type<metal::int2>(as_type<metal::uint2>(cell) + as_type<metal::uint2>(metal::int2(1, 1))), 0, barchan_tables, barchan_height_texels);
    metal::float4 _e22 = barchan_relief_depths(metal::float4(_e2, _e8, _e14, _e20), barchan_tables);
    return _e22;
}

float barchan_relief_twist(
    metal::float4 corners
) {
    return (corners.x - corners.y) + (corners.w - corners.z);
}

float barchan_relief_cell_gap(
    BarchanReliefRay ray_6,
    metal::int2 cell_1,
    metal::float4 corners_1,
    float depth_4
) {
    metal::float2 place_9 = (ray_6.place - static_cast<metal::float2>(cell_1)) + (depth_4 * ray_6.step);
    float plane = (corners_1.x + ((corners_1.y - corners_1.x) * place_9.x)) + ((corners_1.z - corners_1.x) * place_9.y);
    float _e23 = barchan_relief_twist(corners_1);
    return (plane + ((_e23 * place_9.x) * place_9.y)) - depth_4;
}

float barchan_relief_gap(
    BarchanReliefRay ray_7,
    float depth_5,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels
) {
    metal::float2 _e2 = barchan_relief_at(ray_7, depth_5);
    metal::int2 cell_7 = naga_f2i32(metal::floor(_e2));
    metal::float4 _e5 = barchan_relief_corners(cell_7, barchan_tables, barchan_height_texels);
    float _e6 = barchan_relief_cell_gap(ray_7, cell_7, _e5, depth_5);
    return _e6;
}

float barchan_relief_first_zero(
    float g0_,
    float g1_,
    float c
) {
    bool local_5 = {};
    bool local_6 = {};
    bool local_7 = {};
    float s = 1.0;
    bool local_8 = {};
    if (g0_ <= 0.0) {
        return 0.0;
    }
    float b = (g1_ - g0_) - c;
    float discriminant = (b * b) - ((4.0 * c) * g0_);
    if (g1_ > 0.0) {
        if (!((c <= 0.0))) {
            local_6 = b >= 0.0;
        } else {
            local_6 = true;
        }
        bool _e25 = local_6;
        if (!(_e25)) {
            local_7 = discriminant < 0.0;
        } else {
            local_7 = true;
        }
        bool _e32 = local_7;
        local_5 = _e32;
    } else {
        local_5 = false;
    }
    bool _e34 = local_5;
    if (_e34) {
        return -1.0;
    }
    float root_1 = metal::sqrt(metal::max(discriminant, 0.0));
    if (b <= 0.0) {
        s = (2.0 * g0_) / (root_1 - b);
    } else {
        s = (root_1 + b) / (-2.0 * c);
    }
    if (g1_ > 0.0) {
        float _e55 = s;
        local_8 = _e55 > 1.0;
    } else {
        local_8 = false;
    }
    bool _e59 = local_8;
    if (_e59) {
        return -1.0;
    }
    float _e61 = s;
    return metal::min(_e61, 1.0);
}

float barchan_relief_hit(
    BarchanReliefRay ray_8,
    metal::int2 cell_2,
    metal::float4 corners_2,
    float start_3,
    float end
) {
    float part_1 = end - start_3;
    float _e6 = barchan_relief_twist(corners_2);
    float twist = (_e6 * (part_1 * ray_8.step.x)) * (part_1 * ray_8.step.y);
    float _e15 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, start_3);
    float _e16 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, end);
    float _e17 = barchan_relief_first_zero(_e15, _e16, twist);
    return (_e17 < 0.0) ? -1.0 : (start_3 + (_e17 * part_1));
}

BarchanReliefLeft barchan_relief_leave(
    BarchanReliefRay ray_9,
    BarchanStart start_4,
    float step,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels
) {
    bool local_9 = {};
    float inside = {};
    int fetches = 1;
    float depth_9 = (start_4.depth > 0.0) ? metal::min(start_4.depth, 1.0) : 0.0;
    if (!(start_4.is_proven)) {
        local_9 = depth_9 == 0.0;
    } else {
        local_9 = true;
    }
    bool _e18 = local_9;
    if (_e18) {
        return BarchanReliefLeft {depth_9, depth_9, false, {}, 0};
    }
    float _e22 = barchan_relief_gap(ray_9, depth_9, barchan_tables, barchan_height_texels);
    if (_e22 > 0.0) {
        return BarchanReliefLeft {depth_9, depth_9, false, {}, 1};
    }
    inside = depth_9;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e48 = fetches;
            fetches = as_type<int>(as_type<uint>(_e48) + as_type<uint>(1));
        }
        loop_init = false;
        int _e31 = fetches;
        if (_e31 <= BARCHAN_MOST_TURNS) {
        } else {
            break;
        }
        {
            float _e34 = inside;
            float outside = _e34 - step;
            if (outside <= 0.0) {
                break;
            }
            float _e38 = barchan_relief_gap(ray_9, outside, barchan_tables, barchan_height_texels);
            if (_e38 > 0.0) {
                float _e41 = inside;
                int _e43 = fetches;
                return BarchanReliefLeft {outside, _e41, true, {}, as_type<int>(as_type<uint>(_e43) + as_type<uint>(1))};
            }
            inside = outside;
        }
    }
    float _e50 = inside;
    int _e52 = fetches;
    return BarchanReliefLeft {0.0, _e50, true, {}, _e52};
}

BarchanStart barchan_relief_start(
    BarchanReliefRay ray_10
) {
    return BarchanStart {0.0, true, {}, metal::int2(0)};
}

int barchan_mip_coarsest(
    constant BarchanTables& barchan_tables
) {
    uint _e3 = barchan_tables.inner[11].first_level;
    uint _e7 = barchan_tables.inner[11].levels;
    return as_type<int>(as_type<uint>(static_cast<int>(_e3 + _e7)) - as_type<uint>(1));
}

int barchan_mip_finest(
    constant BarchanTables& barchan_tables
) {
    uint _e3 = barchan_tables.inner[11].first_level;
    return metal::max(static_cast<int>(_e3), 1);
}

int barchan_mip_level_as_long_as(
    float way,
    int most,
    constant BarchanTables& barchan_tables
) {
    int level_1 = 0;
    bool local_10 = {};
    while(true) {
        int _e4 = level_1;
        if (_e4 < most) {
            int _e8 = level_1;
            local_10 = static_cast<float>(2 << static_cast<uint>(_e8)) <= way;
        } else {
            local_10 = false;
        }
        bool _e15 = local_10;
        if (_e15) {
        } else {
            break;
        }
        {
            int _e17 = level_1;
            level_1 = as_type<int>(as_type<uint>(_e17) + as_type<uint>(1));
        }
    }
    int _e19 = level_1;
    int _e20 = level_1;
    int _e21 = barchan_mip_finest(barchan_tables);
    return (_e20 < _e21) ? 0 : _e19;
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

metal::int3 barchan_mip_range(
    bool repeats,
    int cell_3,
    int size,
    int level_2
) {
    bool local_11 = {};
    bool local_12 = {};
    int last = as_type<int>(as_type<uint>(metal::max(size >> static_cast<uint>(level_2), 1)) - as_type<uint>(1));
    int repeated_1 = naga_mod(as_type<int>(as_type<uint>(naga_mod(cell_3, size)) + as_type<uint>(size)), size);
    int inside_1 = repeats ? repeated_1 : metal::clamp(cell_3, 0, as_type<int>(as_type<uint>(size) - as_type<uint>(1)));
    int tile = repeats ? as_type<int>(as_type<uint>(cell_3) - as_type<uint>(inside_1)) : 0;
    int texel = metal::min(inside_1 >> static_cast<uint>(level_2), last);
    int low_2 = texel << static_cast<uint>(level_2);
    int high_2 = (texel == last) ? size : (as_type<int>(as_type<uint>(texel) + as_type<uint>(1)) << static_cast<uint>(level_2));
    if (repeats) {
        return metal::int3(as_type<int>(as_type<uint>(tile) + as_type<uint>(low_2)), as_type<int>(as_type<uint>(tile) + as_type<uint>(high_2)), texel);
    }
    if (level_2 == 0) {
        local_11 = cell_3 < 0;
    } else {
        local_11 = false;
    }
    bool _e42 = local_11;
    if (_e42) {
        return metal::int3(-33554432, 0, texel);
    }
    if (level_2 > 0) {
        local_12 = texel == 0;
    } else {
        local_12 = false;
    }
    bool _e54 = local_12;
    return metal::int3(_e54 ? -33554432 : low_2, (texel == last) ? BARCHAN_ENDLESS : high_2, texel);
}

BarchanMipBlock barchan_mip_block(
    int level_3,
    metal::int2 cell_4,
    constant BarchanTables& barchan_tables
) {
    metal::float2 _e5 = barchan_tables.inner[0].extent;
    metal::int2 extent_3 = naga_f2i32(_e5);
    uint edges_2 = barchan_tables.inner[0].edges;
    metal::int3 _e17 = barchan_mip_range((edges_2 & 1u) != 0u, cell_4.x, extent_3.x, level_3);
    metal::int3 _e24 = barchan_mip_range((edges_2 & 2u) != 0u, cell_4.y, extent_3.y, level_3);
    return BarchanMipBlock {metal::int2(_e17.x, _e24.x), metal::int2(_e17.y, _e24.y), metal::int2(_e17.z, _e24.z)};
}

int barchan_mip_level_behind(
    BarchanReliefRay ray_11,
    int level_4,
    metal::int2 cell_5,
    metal::int2 next_1,
    float gap,
    constant BarchanTables& barchan_tables
) {
    bool local_13 = {};
    int _e7 = barchan_mip_finest(barchan_tables);
    int above = metal::max(as_type<int>(as_type<uint>(level_4) + as_type<uint>(1)), _e7);
    float _e9 = barchan_relief_way(ray_11);
    bool is_high = (gap * _e9) > static_cast<float>(1 << static_cast<uint>(above));
    int _e16 = barchan_mip_coarsest(barchan_tables);
    if (!((above > _e16))) {
        local_13 = !(is_high);
    } else {
        local_13 = true;
    }
    bool _e23 = local_13;
    if (_e23) {
        return level_4;
    }
    BarchanMipBlock _e24 = barchan_mip_block(above, cell_5, barchan_tables);
    BarchanMipBlock _e26 = barchan_mip_block(above, next_1, barchan_tables);
    bool goes_on = metal::all(_e24.texel == _e26.texel);
    return goes_on ? level_4 : above;
}

BarchanFound barchan_relief_search(
    BarchanReliefRay ray_12,
    BarchanStart start_5,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels,
    metal::texture2d<float, metal::access::sample> barchan_maximum_mip_texels
) {
    metal::int2 fetches_1 = {};
    float depth_6 = {};
    metal::int2 cell_6 = {};
    int level_5 = {};
    int turn = 0;
    float gap_1 = {};
    bool local_14 = {};
    BarchanReliefLeft _e3 = barchan_relief_leave(ray_12, start_5, BARCHAN_STEP_BACK, barchan_tables, barchan_height_texels);
    uint _e7 = barchan_tables.inner[11].first_level;
    int first_level = static_cast<int>(_e7);
    fetches_1 = as_type<metal::int2>(as_type<metal::uint2>(start_5.fetches) + as_type<metal::uint2>(metal::int2(_e3.fetches, 0)));
    depth_6 = _e3.outside;
    float _e17 = depth_6;
    metal::int2 _e18 = barchan_relief_cell(ray_12, _e17);
    cell_6 = _e18;
    float _e20 = depth_6;
    float _e21 = barchan_relief_way_ahead(ray_12, _e20);
    int _e22 = barchan_mip_coarsest(barchan_tables);
    int _e23 = barchan_mip_level_as_long_as(_e21, _e22, barchan_tables);
    level_5 = _e23;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e113 = turn;
            turn = as_type<int>(as_type<uint>(_e113) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e27 = turn;
        if (_e27 < BARCHAN_MOST_TURNS) {
        } else {
            break;
        }
        {
            int _e30 = level_5;
            metal::int2 _e31 = cell_6;
            BarchanMipBlock _e32 = barchan_mip_block(_e30, _e31, barchan_tables);
            float _e35 = depth_6;
            BarchanReliefExit _e36 = barchan_relief_exit(ray_12, _e32.low, _e32.high, _e35);
            gap_1 = 0.0;
            int _e39 = level_5;
            if (_e39 == 0) {
                int _e44 = fetches_1.x;
                fetches_1.x = as_type<int>(as_type<uint>(_e44) + as_type<uint>(1));
                metal::int2 _e46 = cell_6;
                metal::float4 _e47 = barchan_relief_corners(_e46, barchan_tables, barchan_height_texels);
                metal::int2 _e48 = cell_6;
                float _e49 = depth_6;
                float _e51 = barchan_relief_hit(ray_12, _e48, _e47, _e49, _e36.depth);
                if (_e51 >= 0.0) {
                    metal::int2 _e54 = fetches_1;
                    return BarchanFound {_e51, {}, _e54};
                }
                if (_e36.depth >= 1.0) {
                    metal::int2 _e59 = fetches_1;
                    return BarchanFound {1.0, {}, _e59};
                }
                metal::int2 _e62 = cell_6;
                float _e64 = barchan_relief_cell_gap(ray_12, _e62, _e47, _e36.depth);
                gap_1 = _e64;
            } else {
                int _e67 = fetches_1.y;
                fetches_1.y = as_type<int>(as_type<uint>(_e67) + as_type<uint>(1));
                int _e70 = level_5;
                float _e72 = barchan_maximum_mip_texel(_e32.texel, as_type<int>(as_type<uint>(_e70) - as_type<uint>(first_level)), barchan_tables, barchan_maximum_mip_texels);
                float _e73 = barchan_relief_depth(_e72, barchan_tables);
                if (_e73 > _e36.depth) {
                    local_14 = _e36.depth < 1.0;
                } else {
                    local_14 = false;
                }
                bool _e82 = local_14;
                if (!(_e82)) {
                    float _e84 = depth_6;
                    depth_6 = metal::max(_e84, metal::min(_e73, _e36.depth));
                    float _e89 = depth_6;
                    float _e91 = barchan_relief_way(ray_12);
                    float way_left = (_e36.depth - _e89) * _e91;
                    float _e95 = depth_6;
                    metal::int2 _e96 = barchan_relief_cell_of(ray_12, _e32.low, _e32.high, _e95);
                    cell_6 = _e96;
                    int _e99 = level_5;
                    int _e102 = barchan_mip_level_as_long_as(BARCHAN_LONGEST_BLOCK * way_left, as_type<int>(as_type<uint>(_e99) - as_type<uint>(1)), barchan_tables);
                    level_5 = _e102;
                    continue;
                }
                gap_1 = _e73 - _e36.depth;
            }
            int _e105 = level_5;
            metal::int2 _e106 = cell_6;
            float _e108 = gap_1;
            int _e109 = barchan_mip_level_behind(ray_12, _e105, _e106, _e36.next, _e108, barchan_tables);
            level_5 = _e109;
            depth_6 = _e36.depth;
            cell_6 = _e36.next;
        }
    }
    float _e115 = depth_6;
    metal::int2 _e116 = fetches_1;
    return BarchanFound {_e115, {}, _e116};
}

BarchanFound barchan_relief_find(
    BarchanReliefRay ray_13,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels,
    metal::texture2d<float, metal::access::sample> barchan_maximum_mip_texels
) {
    if (!(ray_13.is_valid)) {
        return BarchanFound {0.0, {}, metal::int2(0)};
    }
    BarchanStart _e7 = barchan_relief_start(ray_13);
    BarchanFound _e8 = barchan_relief_search(ray_13, _e7, barchan_tables, barchan_height_texels, barchan_maximum_mip_texels);
    return _e8;
}

metal::float2 barchan_probe_place(
    metal::float4 position_2,
    constant BarchanProbe& barchan_probe
) {
    metal::float2 _e3 = barchan_probe.place;
    metal::float2 _e8 = barchan_probe.step;
    return _e3 + (metal::floor(position_2.xy) * _e8);
}

bool barchan_relief_in_shadow(
    metal::float2 place_8,
    float depth_7,
    metal::float3 towards_3,
    float tolerance,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels,
    metal::texture2d<float, metal::access::sample> barchan_maximum_mip_texels
) {
    bool local_15 = {};
    BarchanReliefRay _e4 = barchan_relief_ray_through(place_8, depth_7, towards_3, barchan_tables);
    if (!(_e4.is_valid)) {
        return true;
    }
    float clear = depth_7 - tolerance;
    BarchanStart _e9 = barchan_relief_start(_e4);
    if (_e9.is_proven) {
        local_15 = _e9.depth >= clear;
    } else {
        local_15 = false;
    }
    bool _e16 = local_15;
    if (_e16) {
        return false;
    }
    BarchanFound _e18 = barchan_relief_search(_e4, _e9, barchan_tables, barchan_height_texels, barchan_maximum_mip_texels);
    return _e18.depth < clear;
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


struct barchan_probe_reliefInput {
};
struct barchan_probe_reliefOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment barchan_probe_reliefOutput barchan_probe_relief(
  metal::float4 position [[position]]
, constant BarchanTables& barchan_tables [[buffer(0)]]
, metal::texture2d<float, metal::access::sample> barchan_height_texels [[texture(2)]]
, metal::texture2d<float, metal::access::sample> barchan_maximum_mip_texels [[texture(13)]]
, constant BarchanProbe& barchan_probe [[buffer(14)]]
) {
    metal::float2 _e1 = barchan_probe_place(position, barchan_probe);
    metal::float3 _e4 = barchan_probe.eye;
    BarchanReliefRay _e5 = barchan_relief_ray(_e1, _e4, barchan_tables);
    if (!(_e5.is_valid)) {
        return barchan_probe_reliefOutput { metal::float4(-1.0, 0.0, 0.0, 0.0) };
    }
    BarchanStart _e13 = barchan_relief_start(_e5);
    BarchanFound _e14 = barchan_relief_search(_e5, _e13, barchan_tables, barchan_height_texels, barchan_maximum_mip_texels);
    return barchan_probe_reliefOutput { metal::float4(_e14.depth, static_cast<metal::float2>(_e14.fetches), _e13.depth) };
}


struct barchan_probe_relief_shadowInput {
};
struct barchan_probe_relief_shadowOutput {
    metal::float4 member_2 [[color(0)]];
};
fragment barchan_probe_relief_shadowOutput barchan_probe_relief_shadow(
  metal::float4 position_1 [[position]]
, constant BarchanTables& barchan_tables [[buffer(0)]]
, metal::texture2d<float, metal::access::sample> barchan_height_texels [[texture(2)]]
, metal::texture2d<float, metal::access::sample> barchan_maximum_mip_texels [[texture(13)]]
, constant BarchanProbe& barchan_probe [[buffer(14)]]
) {
    metal::float2 _e1 = barchan_probe_place(position_1, barchan_probe);
    metal::float3 _e4 = barchan_probe.eye;
    BarchanReliefRay _e5 = barchan_relief_ray(_e1, _e4, barchan_tables);
    BarchanFound _e6 = barchan_relief_find(_e5, barchan_tables, barchan_height_texels, barchan_maximum_mip_texels);
    float depth_10 = _e6.depth;
    metal::float2 _e8 = barchan_relief_at(_e5, depth_10);
    metal::float3 _e11 = barchan_probe.light;
    float _e14 = barchan_probe.tolerance;
    bool _e15 = barchan_relief_in_shadow(_e8, depth_10, _e11, _e14, barchan_tables, barchan_height_texels, barchan_maximum_mip_texels);
    return barchan_probe_relief_shadowOutput { metal::float4(depth_10, _e15 ? 1.0 : 0.0, 0.0, 0.0) };
}
