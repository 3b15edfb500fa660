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
struct BarchanGround {
    float curvature;
    float stretch;
    float lowest;
    float floor_curvature;
};
struct BarchanPoint {
    float sine;
    float cosine;
    float distance;
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
constant uint BARCHAN_HORIZON = 1u;
constant uint BARCHAN_DISTANCE = 2u;
constant float BARCHAN_TURN = 6.2831855;
constant float BARCHAN_NO_HORIZON = -340000000000000000000000000000000000000.0;
constant float BARCHAN_CLOSED = 340000000000000000000000000000000000000.0;
constant float BARCHAN_GREATEST_ELEVATION = 1.5707963;
constant float BARCHAN_LEAST_COSINE = 0.00000007549789;

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
    float sine_2 = metal::min(size_2.x, size_2.y) / larger;
    float _e13 = barchan_arctangent(sine_2);
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
    float sine_3 = ((((((-0.00019515296 * square_2) + 0.008332161) * square_2) - 0.16666655) * square_2) * rest) + rest;
    float cosine = (((((((0.000024433157 * square_2) - 0.0013887316) * square_2) + 0.041666646) * square_2) * square_2) - (0.5 * square_2)) + 1.0;
    int turned = naga_f2i32(quarter) & 3;
    metal::float2 swapped = ((turned & 1) != 0) ? metal::float2(cosine, sine_3) : metal::float2(sine_3, cosine);
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
    uint first_2 = barchan_tables.inner[table].first_level;
    metal::float2 _e10 = barchan_tables.inner[table].extent;
    metal::int2 whole = naga_f2i32(_e10);
    metal::int2 extent_1 = metal::max(whole >> metal::uint2(first_2 + static_cast<uint>(level)), metal::int2(1));
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

float barchan_horizon_before_transfer(
    metal::int2 place_3,
    int layer_2,
    constant BarchanTables& barchan_tables,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels
) {
    metal::int2 _e4 = barchan_inside(BARCHAN_HORIZON, place_3, 0, barchan_tables);
    metal::float4 _e8 = barchan_horizon_texels.read(metal::uint2(_e4), layer_2, 0);
    float _e10 = barchan_scaled(BARCHAN_HORIZON, _e8.x, barchan_tables);
    return _e10;
}

float barchan_horizon_texel(
    metal::int2 place_4,
    int layer_3,
    constant BarchanTables& barchan_tables,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels
) {
    float _e3 = barchan_horizon_before_transfer(place_4, layer_3, barchan_tables, barchan_horizon_texels);
    float _e4 = barchan_transferred(BARCHAN_HORIZON, _e3, barchan_tables);
    return _e4;
}

float barchan_distance_before_transfer(
    metal::int2 place_5,
    int layer_4,
    constant BarchanTables& barchan_tables,
    metal::texture2d_array<float, metal::access::sample> barchan_distance_texels
) {
    metal::int2 _e4 = barchan_inside(BARCHAN_DISTANCE, place_5, 0, barchan_tables);
    metal::float4 _e8 = barchan_distance_texels.read(metal::uint2(_e4), layer_4, 0);
    float _e10 = barchan_scaled(BARCHAN_DISTANCE, _e8.x, barchan_tables);
    return _e10;
}

float barchan_distance_texel(
    metal::int2 place_6,
    int layer_5,
    constant BarchanTables& barchan_tables,
    metal::texture2d_array<float, metal::access::sample> barchan_distance_texels
) {
    float _e3 = barchan_distance_before_transfer(place_6, layer_5, barchan_tables, barchan_distance_texels);
    float _e4 = barchan_transferred(BARCHAN_DISTANCE, _e3, barchan_tables);
    return _e4;
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
        int first_3 = naga_mod(naga_f2i32(index_1), count);
        return BarchanNeighbours {first_3, naga_mod(as_type<int>(as_type<uint>(first_3) + as_type<uint>(1)), count), weight};
    }
    int last = as_type<int>(as_type<uint>(count) - as_type<uint>(1));
    float span = static_cast<float>(last) * step;
    if (offset < span) {
        int first_4 = metal::min(naga_f2i32(index_1), as_type<int>(as_type<uint>(last) - as_type<uint>(1)));
        return BarchanNeighbours {first_4, as_type<int>(as_type<uint>(first_4) + as_type<uint>(1)), metal::min(position_2 - static_cast<float>(first_4), 1.0)};
    }
    int end = ((BARCHAN_TURN - offset) <= (offset - span)) ? 0 : last;
    return BarchanNeighbours {end, end, 0.0};
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
    bool local_2 = {};
    float height_4 = metal::dot(towards, normal_1);
    metal::float3 tangent_1 = towards - (normal_1 * height_4);
    float level_1 = metal::length(tangent_1);
    metal::float2 _e9 = barchan_texture_step(along_u_3, along_v_3, tangent_1);
    metal::float2 on_grid = _e9 * extent;
    float grid_length = metal::length(on_grid);
    if (level_1 > 0.0) {
        local_2 = grid_length > 0.0;
    } else {
        local_2 = false;
    }
    bool _e19 = local_2;
    if (!(_e19)) {
        return BarchanTangentLight {height_4, level_1, _e9, 0.0, 1.0};
    }
    float _e24 = barchan_azimuth(on_grid);
    return BarchanTangentLight {height_4, level_1, _e9, _e24, level_1 / grid_length};
}

float barchan_mean_curvature(
    metal::float3 first,
    metal::float3 second
) {
    float area_squared_1 = (first.x * first.z) - (first.y * first.y);
    if (!((area_squared_1 > 0.0))) {
        return 0.0;
    }
    return (((second.x * first.z) - ((2.0 * second.y) * first.y)) + (second.z * first.x)) / (2.0 * area_squared_1);
}

float barchan_curvature_along(
    metal::float3 first_1,
    metal::float3 second_1,
    metal::float2 direction_1
) {
    float larger_1 = metal::max(metal::abs(direction_1.x), metal::abs(direction_1.y));
    if (!((larger_1 > 0.0))) {
        float _e11 = barchan_mean_curvature(first_1, second_1);
        return _e11;
    }
    metal::float2 step_1 = direction_1 / metal::float2(larger_1);
    metal::float3 products = metal::float3(step_1.x * step_1.x, (2.0 * step_1.x) * step_1.y, step_1.y * step_1.y);
    float length_squared = metal::dot(first_1, products);
    if (!((length_squared > 0.0))) {
        float _e30 = barchan_mean_curvature(first_1, second_1);
        return _e30;
    }
    return metal::dot(second_1, products) / length_squared;
}

float barchan_further_slope(
    BarchanGround ground,
    metal::int2 texel,
    float height,
    int azimuth_1
) {
    return BARCHAN_NO_HORIZON;
}

BarchanPoint barchan_point_of(
    uint table_10,
    float stored_4,
    float distance,
    constant BarchanTables& barchan_tables
) {
    uint _e6 = barchan_tables.inner[table_10].transfer;
    if (_e6 == 1u) {
        float sine_4 = metal::clamp(stored_4, -1.0, 1.0);
        return BarchanPoint {sine_4, metal::max(metal::sqrt((1.0 - sine_4) * (1.0 + sine_4)), BARCHAN_LEAST_COSINE), distance};
    }
    metal::float2 _e24 = barchan_sine_cosine(metal::clamp(stored_4, -1.5707963, BARCHAN_GREATEST_ELEVATION));
    return BarchanPoint {_e24.x, metal::max(_e24.y, BARCHAN_LEAST_COSINE), distance};
}

BarchanGround barchan_ground(
    float curvature,
    float stretch,
    float lowest
) {
    float widened = 1.0 + (curvature * lowest);
    if (!(((curvature * widened) > 0.0))) {
        return BarchanGround {curvature, stretch, lowest, 0.0};
    }
    return BarchanGround {curvature, stretch, lowest, metal::min(curvature / widened, 1000000000000000000000000000000.0)};
}

float barchan_sinc(
    float x,
    float sine_1
) {
    if (metal::abs(x) < 0.04) {
        return 1.0 - ((x * x) / 6.0);
    }
    return sine_1 / x;
}

float barchan_carried_slope(
    BarchanGround ground_1,
    BarchanPoint point,
    float height_1
) {
    bool local_3 = {};
    bool local_4 = {};
    float angle_3 = ground_1.curvature * (ground_1.stretch * point.distance);
    float raised = 1.0 + (ground_1.curvature * height_1);
    if (angle_3 < 1.5707963) {
        local_3 = angle_3 > -3.1415925;
    } else {
        local_3 = false;
    }
    bool _e19 = local_3;
    if (_e19) {
        local_4 = raised > 0.0;
    } else {
        local_4 = false;
    }
    bool _e25 = local_4;
    if (!(_e25)) {
        return BARCHAN_NO_HORIZON;
    }
    float run = point.cosine * ground_1.stretch;
    float widened_1 = (run * raised) + (angle_3 * point.sine);
    if (!((widened_1 > 0.0))) {
        return (ground_1.curvature > 0.0) ? BARCHAN_NO_HORIZON : BARCHAN_CLOSED;
    }
    metal::float2 _e46 = barchan_sine_cosine(0.5 * angle_3);
    float _e50 = barchan_sinc(0.5 * angle_3, _e46.x);
    float rise = (point.sine * (1.0 - ((2.0 * _e46.x) * _e46.x))) - (((run * raised) * _e46.x) * _e50);
    return metal::clamp(rise / ((widened_1 * _e50) * _e46.y), BARCHAN_NO_HORIZON, BARCHAN_CLOSED);
}

float barchan_smooth_slope(
    BarchanGround ground_2,
    float height_2
) {
    if (ground_2.floor_curvature <= 0.0) {
        return BARCHAN_NO_HORIZON;
    }
    float raised_1 = metal::max(ground_2.floor_curvature * (height_2 - ground_2.lowest), 0.0);
    return -(metal::sqrt(raised_1 * (2.0 + raised_1)));
}

float barchan_curved_towards(
    BarchanGround ground_3,
    metal::int2 texel_1,
    float height_3,
    int azimuth_2,
    constant BarchanTables& barchan_tables,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels,
    metal::texture2d_array<float, metal::access::sample> barchan_distance_texels
) {
    float _e4 = barchan_horizon_before_transfer(texel_1, azimuth_2, barchan_tables, barchan_horizon_texels);
    float _e6 = barchan_distance_texel(texel_1, azimuth_2, barchan_tables, barchan_distance_texels);
    BarchanPoint _e7 = barchan_point_of(BARCHAN_HORIZON, _e4, _e6, barchan_tables);
    float _e8 = barchan_smooth_slope(ground_3, height_3);
    float _e9 = barchan_carried_slope(ground_3, _e7, height_3);
    float slope = metal::max(_e8, _e9);
    float _e11 = barchan_further_slope(ground_3, texel_1, height_3, azimuth_2);
    float _e13 = barchan_arctangent(metal::max(slope, _e11));
    return _e13;
}

float barchan_curved_texel(
    BarchanGround ground_4,
    metal::int2 texel_2,
    BarchanNeighbours beside,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels,
    metal::texture2d_array<float, metal::access::sample> barchan_distance_texels
) {
    float elevation = 0.0;
    int side = 0;
    float _e4 = barchan_height_texel(texel_2, 0, barchan_tables, barchan_height_texels);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e33 = side;
            side = as_type<int>(as_type<uint>(_e33) + as_type<uint>(1));
        }
        loop_init = false;
        int _e9 = side;
        if (_e9 < 2) {
        } else {
            break;
        }
        {
            int _e16 = side;
            float weight_1 = (_e16 == 1) ? beside.weight : (1.0 - beside.weight);
            if (weight_1 != 0.0) {
                int _e24 = side;
                int azimuth_3 = (_e24 == 1) ? beside.second : beside.first;
                float _e28 = elevation;
                float _e29 = barchan_curved_towards(ground_4, texel_2, _e4, azimuth_3, barchan_tables, barchan_horizon_texels, barchan_distance_texels);
                elevation = _e28 + (weight_1 * _e29);
            }
        }
    }
    float _e35 = elevation;
    return _e35;
}

float barchan_curved_elevation(
    metal::float2 place_7,
    BarchanTangentLight light,
    float curvature_1,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels,
    metal::texture2d_array<float, metal::access::sample> barchan_distance_texels
) {
    float elevation_1 = 0.0;
    int tap = 0;
    float _e7 = barchan_tables.inner[0].least;
    BarchanGround _e8 = barchan_ground(curvature_1, light.stretch, _e7);
    BarchanNeighbours _e11 = barchan_neighbours(BARCHAN_HORIZON, light.azimuth, barchan_tables);
    metal::float2 corner = metal::floor(place_7);
    metal::float2 part_1 = place_7 - corner;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e45 = tap;
            tap = as_type<int>(as_type<uint>(_e45) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e18 = tap;
        if (_e18 < 4) {
        } else {
            break;
        }
        {
            int _e21 = tap;
            int _e24 = tap;
            metal::int2 offset_1 = metal::int2(_e21 & 1, _e24 >> 1u);
            metal::float2 weights = metal::select(metal::float2(1.0) - part_1, part_1, offset_1 == metal::int2(1));
            float _e35 = elevation_1;
            float _e41 = barchan_curved_texel(_e8, as_type<metal::int2>(as_type<metal::uint2>(naga_f2i32(corner)) + as_type<metal::uint2>(offset_1)), _e11, barchan_tables, barchan_height_texels, barchan_horizon_texels, barchan_distance_texels);
            elevation_1 = _e35 + ((weights.x * weights.y) * _e41);
        }
    }
    float _e47 = elevation_1;
    return metal::clamp(_e47, -1.5707963, BARCHAN_GREATEST_ELEVATION);
}

bool barchan_is_below(
    BarchanTangentLight light_1,
    float elevation_2
) {
    metal::float2 _e2 = barchan_sine_cosine(elevation_2);
    return (light_1.height * _e2.y) < (light_1.level * _e2.x);
}

bool barchan_curved_in_shadow(
    metal::float2 place_8,
    BarchanTangentLight light_2,
    float curvature_2,
    constant BarchanTables& barchan_tables,
    metal::texture2d<float, metal::access::sample> barchan_height_texels,
    metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels,
    metal::texture2d_array<float, metal::access::sample> barchan_distance_texels
) {
    float _e3 = barchan_curved_elevation(place_8, light_2, curvature_2, barchan_tables, barchan_height_texels, barchan_horizon_texels, barchan_distance_texels);
    bool _e4 = barchan_is_below(light_2, _e3);
    return _e4;
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


struct barchan_probe_curvedInput {
};
struct barchan_probe_curvedOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment barchan_probe_curvedOutput barchan_probe_curved(
  metal::float4 position [[position]]
, constant BarchanTables& barchan_tables [[buffer(0)]]
, metal::texture2d<float, metal::access::sample> barchan_height_texels [[texture(2)]]
, metal::texture2d_array<float, metal::access::sample> barchan_horizon_texels [[texture(3)]]
, metal::texture2d_array<float, metal::access::sample> barchan_distance_texels [[texture(4)]]
, constant BarchanProbe& barchan_probe [[buffer(14)]]
) {
    metal::float2 _e1 = barchan_probe_place(position, barchan_probe);
    metal::float2 _e5 = barchan_tables.inner[1].extent;
    metal::float2 _e9 = barchan_tables.inner[1].spacing;
    metal::float2 extent_2 = _e5 * _e9;
    metal::float3 normal_2 = metal::float3(0.0, 0.0, 1.0);
    metal::float3 _e17 = barchan_probe.along_u;
    metal::float3 _e20 = barchan_probe.along_v;
    metal::float3 _e23 = barchan_probe.light;
    BarchanTangentLight _e24 = barchan_tangent_light(_e17, _e20, normal_2, _e23, extent_2);
    metal::float3 _e27 = barchan_probe.first_form;
    metal::float3 _e30 = barchan_probe.second_form;
    float _e32 = barchan_curvature_along(_e27, _e30, _e24.direction);
    float _e33 = barchan_curved_elevation(_e1, _e24, _e32, barchan_tables, barchan_height_texels, barchan_horizon_texels, barchan_distance_texels);
    bool _e34 = barchan_is_below(_e24, _e33);
    return barchan_probe_curvedOutput { metal::float4(_e33, _e34 ? 1.0 : 0.0, _e32, _e24.azimuth) };
}
