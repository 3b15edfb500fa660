#version 300 es

precision highp float;
precision highp int;

struct BarchanTable {
    vec2 extent;
    vec2 spacing;
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
struct BarchanTangentLight {
    float height;
    float level;
    vec2 direction;
    float azimuth;
    float stretch;
};
struct BarchanGradients {
    vec3 of_u;
    vec3 of_v;
};
struct BarchanReliefRay {
    vec2 place;
    vec2 step_;
    vec3 towards;
    float tangent;
    bool is_valid;
};
struct BarchanStart {
    float depth;
    bool is_proven;
    ivec2 fetches;
};
struct BarchanFound {
    float depth;
    ivec2 fetches;
};
struct BarchanReliefExit {
    float depth;
    ivec2 next;
};
struct BarchanReliefLeft {
    float outside;
    float inside;
    bool is_within;
    int fetches;
};
struct BarchanProbe {
    vec2 place;
    vec2 step_;
    vec3 light;
    float angular_radius;
    vec3 eye;
    float level_distance;
    vec3 first_form;
    float tolerance;
    vec3 second_form;
    float unused_0_;
    vec3 along_u;
    float unused_1_;
    vec3 along_v;
    float unused_2_;
};
const uint BARCHAN_HEIGHT = 0u;
const uint BARCHAN_CONE_MAP = 9u;
const float BARCHAN_LONGEST_WAY = 65536.0;
const float BARCHAN_FARTHEST = 16777216.0;
const float BARCHAN_STEEPEST = 1048576.0;
const int BARCHAN_MOST_TURNS = 4096;
const float BARCHAN_STEP_BACK = 0.015625;
const float BARCHAN_NEAR_TEXELS = 0.5;

layout(std140) uniform BarchanTables_block_0Fragment { BarchanTable _group_0_binding_0_fs[12]; };

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_11_fs;

layout(std140) uniform BarchanProbe_block_1Fragment { BarchanProbe _group_0_binding_14_fs; };

layout(location = 0) out vec4 _fs2p_location0;

float barchan_arcsine(float sine) {
    float size = min(abs(sine), 1.0);
    bool is_steep = (size > 0.5);
    float square = (is_steep ? (0.5 * (1.0 - size)) : (size * size));
    float root = (is_steep ? sqrt(square) : size);
    float series = (((((((((((0.0421632 * square) + 0.024181312) * square) + 0.045470025) * square) + 0.074953005) * square) + 0.16666752) * square) * root) + root);
    float angle_1 = (is_steep ? (1.5707963 - (2.0 * series)) : series);
    return ((sine < 0.0) ? -(angle_1) : angle_1);
}

float barchan_arctangent(float tangent) {
    float start = 0.0;
    float part = 0.0;
    float size_1 = abs(tangent);
    part = size_1;
    if ((size_1 > 2.4142137)) {
        start = 1.5707964;
        part = (-1.0 / size_1);
    } else {
        if ((size_1 > 0.41421357)) {
            start = 0.7853982;
            part = ((size_1 - 1.0) / (size_1 + 1.0));
        }
    }
    float _e18 = part;
    float _e19 = part;
    float square_1 = (_e18 * _e19);
    float _e21 = start;
    float _e33 = part;
    float _e35 = part;
    float angle_2 = (_e21 + (((((((((0.080537446 * square_1) - 0.13877685) * square_1) + 0.19977711) * square_1) - 0.3333295) * square_1) * _e33) + _e35));
    return ((tangent < 0.0) ? -(angle_2) : angle_2);
}

float barchan_azimuth(vec2 direction) {
    vec2 size_2 = abs(direction);
    float larger = max(size_2.x, size_2.y);
    if (!((larger > 0.0))) {
        return 0.0;
    }
    float sine_1 = (min(size_2.x, size_2.y) / larger);
    float _e13 = barchan_arctangent(sine_1);
    float quadrant = ((size_2.y > size_2.x) ? (1.5707964 - _e13) : _e13);
    float half_ = ((direction.x < 0.0) ? (3.1415927 - quadrant) : quadrant);
    return ((direction.y < 0.0) ? -(half_) : half_);
}

vec2 barchan_sine_cosine(float angle) {
    bool local = false;
    float quarter = roundEven((angle * 0.63661975));
    float rest = (((angle - (quarter * 1.5703125)) - (quarter * 0.0004837513)) - (quarter * 7.54979e-8));
    float square_2 = (rest * rest);
    float sine_2 = (((((((-0.00019515296 * square_2) + 0.008332161) * square_2) - 0.16666655) * square_2) * rest) + rest);
    float cosine = ((((((((2.4433157e-5 * square_2) - 0.0013887316) * square_2) + 0.041666646) * square_2) * square_2) - (0.5 * square_2)) + 1.0);
    int turned = (int(quarter) & 3);
    vec2 swapped = (((turned & 1) != 0) ? vec2(cosine, sine_2) : vec2(sine_2, cosine));
    if (!((turned == 1))) {
        local = (turned == 2);
    } else {
        local = true;
    }
    bool _e65 = local;
    return vec2(((turned >= 2) ? -(swapped.x) : swapped.x), (_e65 ? -(swapped.y) : swapped.y));
}

ivec2 barchan_chosen(ivec2 other, ivec2 chosen, bvec2 is_chosen) {
    return ivec2((is_chosen.x ? chosen.x : other.x), (is_chosen.y ? chosen.y : other.y));
}

ivec2 barchan_inside(uint table, ivec2 place, int level) {
    uint first = _group_0_binding_0_fs[table].first_level;
    vec2 _e10 = _group_0_binding_0_fs[table].extent;
    ivec2 whole = ivec2(_e10);
    ivec2 extent_1 = max((whole >> uvec2((first + uint(level)))), ivec2(1));
    uint edges = _group_0_binding_0_fs[table].edges;
    ivec2 repeated = (((place % extent_1) + extent_1) % extent_1);
    ivec2 clamped = min(max(place, ivec2(0)), (extent_1 - ivec2(1)));
    ivec2 _e41 = barchan_chosen(clamped, repeated, bvec2(((edges & 1u) != 0u), ((edges & 2u) != 0u)));
    return _e41;
}

float barchan_scaled(uint table_1, float stored) {
    float _e5 = _group_0_binding_0_fs[table_1].scale;
    float _e10 = _group_0_binding_0_fs[table_1].bias;
    return ((_e5 * stored) + _e10);
}

vec2 barchan_scaled_2_(uint table_2, vec2 stored_1) {
    float _e5 = _group_0_binding_0_fs[table_2].scale;
    float _e10 = _group_0_binding_0_fs[table_2].bias;
    return ((_e5 * stored_1) + vec2(_e10));
}

vec4 barchan_scaled_4_(uint table_3, vec4 stored_2) {
    float _e5 = _group_0_binding_0_fs[table_3].scale;
    float _e10 = _group_0_binding_0_fs[table_3].bias;
    return ((_e5 * stored_2) + vec4(_e10));
}

vec2 barchan_scaled_cone(uint table_4, vec2 stored_3) {
    float _e4 = barchan_scaled(table_4, stored_3.y);
    return vec2(stored_3.x, _e4);
}

float barchan_transferred(uint table_5, float number) {
    uint _e5 = _group_0_binding_0_fs[table_5].transfer;
    switch(_e5) {
        case 1u: {
            float _e6 = barchan_arcsine(number);
            return _e6;
        }
        case 2u: {
            return (number * number);
        }
        default: {
            return number;
        }
    }
}

vec2 barchan_transferred_2_(uint table_6, vec2 number_1) {
    return number_1;
}

vec4 barchan_transferred_4_(uint table_7, vec4 number_2) {
    return number_2;
}

vec2 barchan_transferred_cone(uint table_8, vec2 number_3) {
    float _e4 = barchan_transferred(table_8, number_3.y);
    return vec2(number_3.x, _e4);
}

float barchan_height_before_transfer(ivec2 place_1, int layer) {
    ivec2 _e4 = barchan_inside(BARCHAN_HEIGHT, place_1, 0);
    vec4 _e7 = texelFetch(_group_0_binding_2_fs, _e4, layer);
    float _e9 = barchan_scaled(BARCHAN_HEIGHT, _e7.x);
    return _e9;
}

float barchan_height_texel(ivec2 place_2, int layer_1) {
    float _e3 = barchan_height_before_transfer(place_2, layer_1);
    float _e4 = barchan_transferred(BARCHAN_HEIGHT, _e3);
    return _e4;
}

vec2 barchan_cone_map_before_transfer(ivec2 place_3, int layer_2) {
    ivec2 _e4 = barchan_inside(BARCHAN_CONE_MAP, place_3, 0);
    vec4 _e7 = texelFetch(_group_0_binding_11_fs, _e4, layer_2);
    vec2 _e9 = barchan_scaled_cone(BARCHAN_CONE_MAP, _e7.xy);
    return _e9;
}

vec2 barchan_cone_map_texel(ivec2 place_4, int layer_3) {
    vec2 _e3 = barchan_cone_map_before_transfer(place_4, layer_3);
    vec2 _e4 = barchan_transferred_cone(BARCHAN_CONE_MAP, _e3);
    return _e4;
}

vec2 barchan_cone_map_at(vec2 place_5, int layer_4) {
    vec2 _e8 = _group_0_binding_0_fs[9].extent;
    vec2 uv = ((place_5 + vec2(0.5)) / _e8);
    vec4 _e13 = textureLod(_group_0_binding_11_fs, vec2(uv), 0.0);
    vec2 stored_4 = _e13.xy;
    vec2 _e17 = barchan_scaled_cone(BARCHAN_CONE_MAP, stored_4);
    vec2 _e18 = barchan_transferred_cone(BARCHAN_CONE_MAP, _e17);
    return _e18;
}

BarchanGradients barchan_gradients(vec3 along_u, vec3 along_v) {
    vec3 area = cross(along_u, along_v);
    float area_squared = dot(area, area);
    if (!((area_squared > 0.0))) {
        return BarchanGradients(vec3(0.0), vec3(0.0));
    }
    return BarchanGradients((cross(along_v, area) / vec3(area_squared)), (cross(area, along_u) / vec3(area_squared)));
}

vec2 barchan_texture_step(vec3 along_u_1, vec3 along_v_1, vec3 vector) {
    BarchanGradients _e3 = barchan_gradients(along_u_1, along_v_1);
    return vec2(dot(vector, _e3.of_u), dot(vector, _e3.of_v));
}

vec3 barchan_bump_normal(vec3 along_u_2, vec3 along_v_2, vec3 normal, vec2 per_uv) {
    BarchanGradients _e4 = barchan_gradients(along_u_2, along_v_2);
    return normalize(((normal - (per_uv.x * _e4.of_u)) - (per_uv.y * _e4.of_v)));
}

BarchanTangentLight barchan_tangent_light(vec3 along_u_3, vec3 along_v_3, vec3 normal_1, vec3 towards, vec2 extent) {
    bool local_1 = false;
    float height_1 = dot(towards, normal_1);
    vec3 tangent_1 = (towards - (normal_1 * height_1));
    float level_1 = length(tangent_1);
    vec2 _e9 = barchan_texture_step(along_u_3, along_v_3, tangent_1);
    vec2 on_grid = (_e9 * extent);
    float grid_length = length(on_grid);
    if ((level_1 > 0.0)) {
        local_1 = (grid_length > 0.0);
    } else {
        local_1 = false;
    }
    bool _e19 = local_1;
    if (!(_e19)) {
        return BarchanTangentLight(height_1, level_1, _e9, 0.0, 1.0);
    }
    float _e24 = barchan_azimuth(on_grid);
    return BarchanTangentLight(height_1, level_1, _e9, _e24, (level_1 / grid_length));
}

float barchan_relief_thickness() {
    float _e3 = _group_0_binding_0_fs[0].greatest;
    float _e7 = _group_0_binding_0_fs[0].least;
    return (_e3 - _e7);
}

vec4 barchan_relief_depths(vec4 heights) {
    float _e1 = barchan_relief_thickness();
    if (!((_e1 > 0.0))) {
        return vec4(0.0);
    }
    float _e10 = _group_0_binding_0_fs[0].greatest;
    return ((vec4(_e10) - heights) / vec4(_e1));
}

float barchan_relief_depth(float height) {
    vec4 _e2 = barchan_relief_depths(vec4(height));
    return _e2.x;
}

vec2 barchan_relief_in_tile(vec2 place_6) {
    vec2 extent_2 = _group_0_binding_0_fs[0].extent;
    uint edges_1 = _group_0_binding_0_fs[0].edges;
    bvec2 repeats = bvec2(((edges_1 & 1u) != 0u), ((edges_1 & 2u) != 0u));
    vec2 rest_1 = (place_6 - (floor((place_6 / extent_2)) * extent_2));
    return mix(place_6, mix(rest_1, (rest_1 + extent_2), lessThan(rest_1, vec2(0.0))), repeats);
}

BarchanReliefRay barchan_relief_ray(vec2 place_7, vec3 towards_1) {
    bool local_2 = false;
    bool local_3 = false;
    bool local_4 = false;
    vec2 spacing = _group_0_binding_0_fs[0].spacing;
    float _e6 = barchan_relief_thickness();
    float thickness = max(_e6, 0.0);
    float level_2 = length(towards_1.xy);
    float way = (thickness * ((abs(towards_1.x) * spacing.y) + (abs(towards_1.y) * spacing.x)));
    if ((way <= (((BARCHAN_LONGEST_WAY * spacing.x) * spacing.y) * towards_1.z))) {
        local_2 = (level_2 <= (BARCHAN_STEEPEST * towards_1.z));
    } else {
        local_2 = false;
    }
    bool is_short = local_2;
    bool is_near = all(lessThanEqual(abs(place_7), vec2(16777216.0)));
    if ((towards_1.z > 0.0)) {
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
        return BarchanReliefRay(vec2(0.0), vec2(0.0), vec3(0.0, 0.0, 1.0), 0.0, false);
    }
    float run = (thickness / towards_1.z);
    vec2 step_1 = (vec2((-(run) * towards_1.x), (run * towards_1.y)) / spacing);
    vec2 _e74 = barchan_relief_in_tile(place_7);
    return BarchanReliefRay(_e74, step_1, towards_1, (level_2 / towards_1.z), true);
}

BarchanReliefRay barchan_relief_ray_through(vec2 place_8, float depth, vec3 towards_2) {
    BarchanReliefRay _e3 = barchan_relief_ray(place_8, towards_2);
    if (!(_e3.is_valid)) {
        return _e3;
    }
    BarchanReliefRay _e10 = barchan_relief_ray((_e3.place - (depth * _e3.step_)), towards_2);
    return _e10;
}

vec2 barchan_relief_at(BarchanReliefRay ray, float depth_1) {
    return (ray.place + (depth_1 * ray.step_));
}

float barchan_relief_way(BarchanReliefRay ray_1) {
    return max(abs(ray_1.step_.x), abs(ray_1.step_.y));
}

float barchan_relief_way_ahead(BarchanReliefRay ray_2, float start_1) {
    float _e7 = barchan_relief_way(ray_2);
    return (((start_1 > 0.0) ? 0.03125 : 0.25) * _e7);
}

ivec2 barchan_relief_cell(BarchanReliefRay ray_3, float depth_2) {
    vec2 _e2 = barchan_relief_at(ray_3, depth_2);
    return ivec2(mix(floor(_e2), (ceil(_e2) - vec2(1.0)), lessThan(ray_3.step_, vec2(0.0))));
}

ivec2 barchan_relief_cell_of(BarchanReliefRay ray_4, ivec2 low, ivec2 high, float depth_3) {
    ivec2 _e4 = barchan_relief_cell(ray_4, depth_3);
    return min(max(_e4, low), (high - ivec2(1)));
}

BarchanReliefExit barchan_relief_exit(BarchanReliefRay ray_5, ivec2 low_1, ivec2 high_1, float start_2) {
    ivec2 next = ivec2(0);
    bvec2 moves = notEqual(ray_5.step_, vec2(0.0));
    ivec2 _e12 = barchan_chosen(low_1, high_1, greaterThan(ray_5.step_, vec2(0.0)));
    vec2 ends = vec2(_e12);
    vec2 borders = mix(vec2(1e30), ((ends - ray_5.place) / mix(vec2(1.0), ray_5.step_, moves)), moves);
    float depth_8 = min(max(min(borders.x, borders.y), start_2), 1.0);
    ivec2 _e30 = barchan_relief_cell_of(ray_5, low_1, high_1, depth_8);
    next = _e30;
    ivec2 _e39 = barchan_chosen(high_1, (low_1 - ivec2(1)), lessThan(ray_5.step_, vec2(0.0)));
    if ((borders.x <= borders.y)) {
        next.x = _e39.x;
    } else {
        next.y = _e39.y;
    }
    ivec2 _e47 = next;
    return BarchanReliefExit(depth_8, _e47);
}

vec4 barchan_relief_corners(ivec2 cell) {
    float _e2 = barchan_height_texel(cell, 0);
    float _e8 = barchan_height_texel((cell + ivec2(1, 0)), 0);
    float _e14 = barchan_height_texel((cell + ivec2(0, 1)), 0);
    float _e20 = barchan_height_texel((cell + ivec2(1, 1)), 0);
    vec4 _e22 = barchan_relief_depths(vec4(_e2, _e8, _e14, _e20));
    return _e22;
}

float barchan_relief_twist(vec4 corners) {
    return ((corners.x - corners.y) + (corners.w - corners.z));
}

float barchan_relief_cell_gap(BarchanReliefRay ray_6, ivec2 cell_1, vec4 corners_1, float depth_4) {
    vec2 place_10 = ((ray_6.place - vec2(cell_1)) + (depth_4 * ray_6.step_));
    float plane = ((corners_1.x + ((corners_1.y - corners_1.x) * place_10.x)) + ((corners_1.z - corners_1.x) * place_10.y));
    float _e23 = barchan_relief_twist(corners_1);
    return ((plane + ((_e23 * place_10.x) * place_10.y)) - depth_4);
}

float barchan_relief_gap(BarchanReliefRay ray_7, float depth_5) {
    vec2 _e2 = barchan_relief_at(ray_7, depth_5);
    ivec2 cell_4 = ivec2(floor(_e2));
    vec4 _e5 = barchan_relief_corners(cell_4);
    float _e6 = barchan_relief_cell_gap(ray_7, cell_4, _e5, depth_5);
    return _e6;
}

float barchan_relief_first_zero(float g0_, float g1_, float c) {
    bool local_5 = false;
    bool local_6 = false;
    bool local_7 = false;
    float s = 1.0;
    bool local_8 = false;
    if ((g0_ <= 0.0)) {
        return 0.0;
    }
    float b = ((g1_ - g0_) - c);
    float discriminant = ((b * b) - ((4.0 * c) * g0_));
    if ((g1_ > 0.0)) {
        if (!((c <= 0.0))) {
            local_6 = (b >= 0.0);
        } else {
            local_6 = true;
        }
        bool _e25 = local_6;
        if (!(_e25)) {
            local_7 = (discriminant < 0.0);
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
    float root_1 = sqrt(max(discriminant, 0.0));
    if ((b <= 0.0)) {
        s = ((2.0 * g0_) / (root_1 - b));
    } else {
        s = ((root_1 + b) / (-2.0 * c));
    }
    if ((g1_ > 0.0)) {
        float _e55 = s;
        local_8 = (_e55 > 1.0);
    } else {
        local_8 = false;
    }
    bool _e59 = local_8;
    if (_e59) {
        return -1.0;
    }
    float _e61 = s;
    return min(_e61, 1.0);
}

float barchan_relief_hit(BarchanReliefRay ray_8, ivec2 cell_2, vec4 corners_2, float start_3, float end) {
    float part_2 = (end - start_3);
    float _e6 = barchan_relief_twist(corners_2);
    float twist = ((_e6 * (part_2 * ray_8.step_.x)) * (part_2 * ray_8.step_.y));
    float _e15 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, start_3);
    float _e16 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, end);
    float _e17 = barchan_relief_first_zero(_e15, _e16, twist);
    return ((_e17 < 0.0) ? -1.0 : (start_3 + (_e17 * part_2)));
}

BarchanReliefLeft barchan_relief_leave(BarchanReliefRay ray_9, BarchanStart start_4, float step_) {
    bool local_9 = false;
    float inside = 0.0;
    int fetches = 1;
    float depth_9 = ((start_4.depth > 0.0) ? min(start_4.depth, 1.0) : 0.0);
    if (!(start_4.is_proven)) {
        local_9 = (depth_9 == 0.0);
    } else {
        local_9 = true;
    }
    bool _e18 = local_9;
    if (_e18) {
        return BarchanReliefLeft(depth_9, depth_9, false, 0);
    }
    float _e22 = barchan_relief_gap(ray_9, depth_9);
    if ((_e22 > 0.0)) {
        return BarchanReliefLeft(depth_9, depth_9, false, 1);
    }
    inside = depth_9;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e48 = fetches;
            fetches = (_e48 + 1);
        }
        loop_init = false;
        int _e31 = fetches;
        if ((_e31 <= BARCHAN_MOST_TURNS)) {
        } else {
            break;
        }
        {
            float _e34 = inside;
            float outside = (_e34 - step_);
            if ((outside <= 0.0)) {
                break;
            }
            float _e38 = barchan_relief_gap(ray_9, outside);
            if ((_e38 > 0.0)) {
                float _e41 = inside;
                int _e43 = fetches;
                return BarchanReliefLeft(outside, _e41, true, (_e43 + 1));
            }
            inside = outside;
        }
    }
    float _e50 = inside;
    int _e52 = fetches;
    return BarchanReliefLeft(0.0, _e50, true, _e52);
}

BarchanStart barchan_relief_start(BarchanReliefRay ray_10) {
    return BarchanStart(0.0, true, ivec2(0));
}

float barchan_relief_cone_step(BarchanReliefRay ray_11, float gap, float ratio) {
    float part_1 = 1.0;
    bool local_10 = false;
    if ((ray_11.tangent > 0.0)) {
        part_1 = ((ratio > 0.0) ? (ratio / (ray_11.tangent + ratio)) : 0.0);
    }
    float _e15 = part_1;
    if ((gap > 0.0)) {
        float _e23 = part_1;
        local_10 = (_e23 > 0.0);
    } else {
        local_10 = false;
    }
    bool _e27 = local_10;
    return (_e27 ? min((gap * _e15), 1.0) : 0.0);
}

BarchanFound barchan_relief_search(BarchanReliefRay ray_12, BarchanStart start_5) {
    ivec2 fetches_1 = ivec2(0);
    float depth_6 = 0.0;
    ivec2 cell_3 = ivec2(0);
    bool local_11 = false;
    bool takes_sample = false;
    float ratio_1 = 0.0;
    int turn = 0;
    bool local_12 = false;
    BarchanReliefLeft _e3 = barchan_relief_leave(ray_12, start_5, BARCHAN_STEP_BACK);
    fetches_1 = (start_5.fetches + ivec2(_e3.fetches, 0));
    depth_6 = _e3.outside;
    float _e12 = depth_6;
    ivec2 _e13 = barchan_relief_cell(ray_12, _e12);
    cell_3 = _e13;
    float _e15 = depth_6;
    if (!((_e15 <= 0.0))) {
        float _e21 = depth_6;
        float _e22 = barchan_relief_way_ahead(ray_12, _e21);
        local_11 = (_e22 >= BARCHAN_NEAR_TEXELS);
    } else {
        local_11 = true;
    }
    bool _e26 = local_11;
    takes_sample = _e26;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e110 = turn;
            turn = (_e110 + 1);
        }
        loop_init_1 = false;
        int _e32 = turn;
        if ((_e32 < BARCHAN_MOST_TURNS)) {
        } else {
            break;
        }
        {
            ivec2 _e35 = cell_3;
            ivec2 _e36 = cell_3;
            float _e40 = depth_6;
            BarchanReliefExit _e41 = barchan_relief_exit(ray_12, _e35, (_e36 + ivec2(1)), _e40);
            bool _e42 = takes_sample;
            if (_e42) {
                int _e45 = fetches_1.y;
                fetches_1.y = (_e45 + 1);
                float _e47 = depth_6;
                vec2 _e48 = barchan_relief_at(ray_12, _e47);
                vec2 _e50 = barchan_cone_map_at(_e48, 0);
                float _e51 = depth_6;
                float _e53 = depth_6;
                float _e56 = barchan_relief_cone_step(ray_12, (_e50.x - _e53), _e50.y);
                float next_1 = min((_e51 + _e56), 1.0);
                ratio_1 = _e50.y;
                if ((next_1 > _e41.depth)) {
                    local_12 = (_e41.depth < 1.0);
                } else {
                    local_12 = false;
                }
                bool _e69 = local_12;
                if (_e69) {
                    depth_6 = next_1;
                    ivec2 _e70 = barchan_relief_cell(ray_12, next_1);
                    cell_3 = _e70;
                    continue;
                }
            }
            int _e73 = fetches_1.x;
            fetches_1.x = (_e73 + 1);
            ivec2 _e75 = cell_3;
            vec4 _e76 = barchan_relief_corners(_e75);
            ivec2 _e77 = cell_3;
            float _e78 = depth_6;
            float _e80 = barchan_relief_hit(ray_12, _e77, _e76, _e78, _e41.depth);
            if ((_e80 >= 0.0)) {
                ivec2 _e83 = fetches_1;
                return BarchanFound(_e80, _e83);
            }
            if ((_e41.depth >= 1.0)) {
                ivec2 _e88 = fetches_1;
                return BarchanFound(1.0, _e88);
            }
            ivec2 _e91 = cell_3;
            float _e93 = barchan_relief_cell_gap(ray_12, _e91, _e76, _e41.depth);
            depth_6 = _e41.depth;
            cell_3 = _e41.next;
            float _e96 = depth_6;
            float _e97 = ratio_1;
            float _e98 = barchan_relief_cone_step(ray_12, _e93, _e97);
            ivec2 _e100 = cell_3;
            ivec2 _e101 = cell_3;
            float _e105 = depth_6;
            BarchanReliefExit _e106 = barchan_relief_exit(ray_12, _e100, (_e101 + ivec2(1)), _e105);
            takes_sample = ((_e96 + _e98) > _e106.depth);
        }
    }
    float _e112 = depth_6;
    ivec2 _e113 = fetches_1;
    return BarchanFound(_e112, _e113);
}

BarchanFound barchan_relief_find(BarchanReliefRay ray_13) {
    if (!(ray_13.is_valid)) {
        return BarchanFound(0.0, ivec2(0));
    }
    BarchanStart _e7 = barchan_relief_start(ray_13);
    BarchanFound _e8 = barchan_relief_search(ray_13, _e7);
    return _e8;
}

vec2 barchan_probe_place(vec4 position_2) {
    vec2 _e3 = _group_0_binding_14_fs.place;
    vec2 _e8 = _group_0_binding_14_fs.step_;
    return (_e3 + (floor(position_2.xy) * _e8));
}

bool barchan_relief_in_shadow(vec2 place_9, float depth_7, vec3 towards_3, float tolerance) {
    bool local_13 = false;
    BarchanReliefRay _e4 = barchan_relief_ray_through(place_9, depth_7, towards_3);
    if (!(_e4.is_valid)) {
        return true;
    }
    float clear = (depth_7 - tolerance);
    BarchanStart _e9 = barchan_relief_start(_e4);
    if (_e9.is_proven) {
        local_13 = (_e9.depth >= clear);
    } else {
        local_13 = false;
    }
    bool _e16 = local_13;
    if (_e16) {
        return false;
    }
    BarchanFound _e18 = barchan_relief_search(_e4, _e9);
    return (_e18.depth < clear);
}

void main() {
    vec4 position_1 = gl_FragCoord;
    vec2 _e1 = barchan_probe_place(position_1);
    vec3 _e4 = _group_0_binding_14_fs.eye;
    BarchanReliefRay _e5 = barchan_relief_ray(_e1, _e4);
    BarchanFound _e6 = barchan_relief_find(_e5);
    float depth_10 = _e6.depth;
    vec2 _e8 = barchan_relief_at(_e5, depth_10);
    vec3 _e11 = _group_0_binding_14_fs.light;
    float _e14 = _group_0_binding_14_fs.tolerance;
    bool _e15 = barchan_relief_in_shadow(_e8, depth_10, _e11, _e14);
    _fs2p_location0 = vec4(depth_10, (_e15 ? 1.0 : 0.0), 0.0, 0.0);
    return;
}

