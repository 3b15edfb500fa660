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
struct BarchanNeighbours {
    int first;
    int second;
    float weight;
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
struct BarchanGround {
    float curvature;
    float stretch;
    float lowest;
    float floor_curvature;
};
struct BarchanPoint {
    float sine;
    float cosine;
    float distance_;
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
const uint BARCHAN_HORIZON = 1u;
const uint BARCHAN_DISTANCE = 2u;
const float BARCHAN_TURN = 6.2831855;
const float BARCHAN_NO_HORIZON = -3.4e38;
const float BARCHAN_CLOSED = 3.4e38;
const float BARCHAN_GREATEST_ELEVATION = 1.5707963;
const float BARCHAN_LEAST_COSINE = 7.549789e-8;

layout(std140) uniform BarchanTables_block_0Fragment { BarchanTable _group_0_binding_0_fs[12]; };

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2DArray _group_0_binding_3_fs;

uniform highp sampler2DArray _group_0_binding_4_fs;

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
    float sine_2 = (min(size_2.x, size_2.y) / larger);
    float _e13 = barchan_arctangent(sine_2);
    float quadrant = ((size_2.y > size_2.x) ? (1.5707964 - _e13) : _e13);
    float half_ = ((direction.x < 0.0) ? (3.1415927 - quadrant) : quadrant);
    return ((direction.y < 0.0) ? -(half_) : half_);
}

vec2 barchan_sine_cosine(float angle) {
    bool local = false;
    float quarter = roundEven((angle * 0.63661975));
    float rest = (((angle - (quarter * 1.5703125)) - (quarter * 0.0004837513)) - (quarter * 7.54979e-8));
    float square_2 = (rest * rest);
    float sine_3 = (((((((-0.00019515296 * square_2) + 0.008332161) * square_2) - 0.16666655) * square_2) * rest) + rest);
    float cosine = ((((((((2.4433157e-5 * square_2) - 0.0013887316) * square_2) + 0.041666646) * square_2) * square_2) - (0.5 * square_2)) + 1.0);
    int turned = (int(quarter) & 3);
    vec2 swapped = (((turned & 1) != 0) ? vec2(cosine, sine_3) : vec2(sine_3, cosine));
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
    uint first_2 = _group_0_binding_0_fs[table].first_level;
    vec2 _e10 = _group_0_binding_0_fs[table].extent;
    ivec2 whole = ivec2(_e10);
    ivec2 extent_1 = max((whole >> uvec2((first_2 + uint(level)))), ivec2(1));
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

float barchan_horizon_before_transfer(ivec2 place_3, int layer_2) {
    ivec2 _e4 = barchan_inside(BARCHAN_HORIZON, place_3, 0);
    vec4 _e8 = texelFetch(_group_0_binding_3_fs, ivec3(_e4, layer_2), 0);
    float _e10 = barchan_scaled(BARCHAN_HORIZON, _e8.x);
    return _e10;
}

float barchan_horizon_texel(ivec2 place_4, int layer_3) {
    float _e3 = barchan_horizon_before_transfer(place_4, layer_3);
    float _e4 = barchan_transferred(BARCHAN_HORIZON, _e3);
    return _e4;
}

float barchan_distance_before_transfer(ivec2 place_5, int layer_4) {
    ivec2 _e4 = barchan_inside(BARCHAN_DISTANCE, place_5, 0);
    vec4 _e8 = texelFetch(_group_0_binding_4_fs, ivec3(_e4, layer_4), 0);
    float _e10 = barchan_scaled(BARCHAN_DISTANCE, _e8.x);
    return _e10;
}

float barchan_distance_texel(ivec2 place_6, int layer_5) {
    float _e3 = barchan_distance_before_transfer(place_6, layer_5);
    float _e4 = barchan_transferred(BARCHAN_DISTANCE, _e3);
    return _e4;
}

BarchanNeighbours barchan_neighbours(uint table_9, float azimuth) {
    bool local_1 = false;
    uint _e5 = _group_0_binding_0_fs[table_9].azimuths;
    int count = int(_e5);
    float step_ = _group_0_binding_0_fs[table_9].azimuth_step;
    float _e14 = _group_0_binding_0_fs[table_9].first_azimuth;
    float turns = ((azimuth - _e14) / BARCHAN_TURN);
    float offset = ((turns - floor(turns)) * BARCHAN_TURN);
    if (!((count <= 1))) {
        local_1 = (step_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e30 = local_1;
    if (_e30) {
        return BarchanNeighbours(0, 0, 0.0);
    }
    float position_2 = (offset / step_);
    float index_1 = floor(position_2);
    float weight = (position_2 - index_1);
    uint _e41 = _group_0_binding_0_fs[table_9].is_circle;
    if ((_e41 != 0u)) {
        int first_3 = (int(index_1) % count);
        return BarchanNeighbours(first_3, ((first_3 + 1) % count), weight);
    }
    int last = (count - 1);
    float span = (float(last) * step_);
    if ((offset < span)) {
        int first_4 = min(int(index_1), (last - 1));
        return BarchanNeighbours(first_4, (first_4 + 1), min((position_2 - float(first_4)), 1.0));
    }
    int end = (((BARCHAN_TURN - offset) <= (offset - span)) ? 0 : last);
    return BarchanNeighbours(end, end, 0.0);
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
    bool local_2 = false;
    float height_4 = dot(towards, normal_1);
    vec3 tangent_1 = (towards - (normal_1 * height_4));
    float level_1 = length(tangent_1);
    vec2 _e9 = barchan_texture_step(along_u_3, along_v_3, tangent_1);
    vec2 on_grid = (_e9 * extent);
    float grid_length = length(on_grid);
    if ((level_1 > 0.0)) {
        local_2 = (grid_length > 0.0);
    } else {
        local_2 = false;
    }
    bool _e19 = local_2;
    if (!(_e19)) {
        return BarchanTangentLight(height_4, level_1, _e9, 0.0, 1.0);
    }
    float _e24 = barchan_azimuth(on_grid);
    return BarchanTangentLight(height_4, level_1, _e9, _e24, (level_1 / grid_length));
}

float barchan_mean_curvature(vec3 first, vec3 second) {
    float area_squared_1 = ((first.x * first.z) - (first.y * first.y));
    if (!((area_squared_1 > 0.0))) {
        return 0.0;
    }
    return ((((second.x * first.z) - ((2.0 * second.y) * first.y)) + (second.z * first.x)) / (2.0 * area_squared_1));
}

float barchan_curvature_along(vec3 first_1, vec3 second_1, vec2 direction_1) {
    float larger_1 = max(abs(direction_1.x), abs(direction_1.y));
    if (!((larger_1 > 0.0))) {
        float _e11 = barchan_mean_curvature(first_1, second_1);
        return _e11;
    }
    vec2 step_1 = (direction_1 / vec2(larger_1));
    vec3 products = vec3((step_1.x * step_1.x), ((2.0 * step_1.x) * step_1.y), (step_1.y * step_1.y));
    float length_squared = dot(first_1, products);
    if (!((length_squared > 0.0))) {
        float _e30 = barchan_mean_curvature(first_1, second_1);
        return _e30;
    }
    return (dot(second_1, products) / length_squared);
}

float barchan_further_slope(BarchanGround ground, ivec2 texel, float height, int azimuth_1) {
    return BARCHAN_NO_HORIZON;
}

BarchanPoint barchan_point_of(uint table_10, float stored_4, float distance_) {
    uint _e6 = _group_0_binding_0_fs[table_10].transfer;
    if ((_e6 == 1u)) {
        float sine_4 = clamp(stored_4, -1.0, 1.0);
        return BarchanPoint(sine_4, max(sqrt(((1.0 - sine_4) * (1.0 + sine_4))), BARCHAN_LEAST_COSINE), distance_);
    }
    vec2 _e24 = barchan_sine_cosine(clamp(stored_4, -1.5707963, BARCHAN_GREATEST_ELEVATION));
    return BarchanPoint(_e24.x, max(_e24.y, BARCHAN_LEAST_COSINE), distance_);
}

BarchanGround barchan_ground(float curvature, float stretch, float lowest) {
    float widened = (1.0 + (curvature * lowest));
    if (!(((curvature * widened) > 0.0))) {
        return BarchanGround(curvature, stretch, lowest, 0.0);
    }
    return BarchanGround(curvature, stretch, lowest, min((curvature / widened), 1e30));
}

float barchan_sinc(float x, float sine_1) {
    if ((abs(x) < 0.04)) {
        return (1.0 - ((x * x) / 6.0));
    }
    return (sine_1 / x);
}

float barchan_carried_slope(BarchanGround ground_1, BarchanPoint point, float height_1) {
    bool local_3 = false;
    bool local_4 = false;
    float angle_3 = (ground_1.curvature * (ground_1.stretch * point.distance_));
    float raised = (1.0 + (ground_1.curvature * height_1));
    if ((angle_3 < 1.5707963)) {
        local_3 = (angle_3 > -3.1415925);
    } else {
        local_3 = false;
    }
    bool _e19 = local_3;
    if (_e19) {
        local_4 = (raised > 0.0);
    } else {
        local_4 = false;
    }
    bool _e25 = local_4;
    if (!(_e25)) {
        return BARCHAN_NO_HORIZON;
    }
    float run = (point.cosine * ground_1.stretch);
    float widened_1 = ((run * raised) + (angle_3 * point.sine));
    if (!((widened_1 > 0.0))) {
        return ((ground_1.curvature > 0.0) ? BARCHAN_NO_HORIZON : BARCHAN_CLOSED);
    }
    vec2 _e46 = barchan_sine_cosine((0.5 * angle_3));
    float _e50 = barchan_sinc((0.5 * angle_3), _e46.x);
    float rise = ((point.sine * (1.0 - ((2.0 * _e46.x) * _e46.x))) - (((run * raised) * _e46.x) * _e50));
    return clamp((rise / ((widened_1 * _e50) * _e46.y)), BARCHAN_NO_HORIZON, BARCHAN_CLOSED);
}

float barchan_smooth_slope(BarchanGround ground_2, float height_2) {
    if ((ground_2.floor_curvature <= 0.0)) {
        return BARCHAN_NO_HORIZON;
    }
    float raised_1 = max((ground_2.floor_curvature * (height_2 - ground_2.lowest)), 0.0);
    return -(sqrt((raised_1 * (2.0 + raised_1))));
}

float barchan_curved_towards(BarchanGround ground_3, ivec2 texel_1, float height_3, int azimuth_2) {
    float _e4 = barchan_horizon_before_transfer(texel_1, azimuth_2);
    float _e6 = barchan_distance_texel(texel_1, azimuth_2);
    BarchanPoint _e7 = barchan_point_of(BARCHAN_HORIZON, _e4, _e6);
    float _e8 = barchan_smooth_slope(ground_3, height_3);
    float _e9 = barchan_carried_slope(ground_3, _e7, height_3);
    float slope = max(_e8, _e9);
    float _e11 = barchan_further_slope(ground_3, texel_1, height_3, azimuth_2);
    float _e13 = barchan_arctangent(max(slope, _e11));
    return _e13;
}

float barchan_curved_texel(BarchanGround ground_4, ivec2 texel_2, BarchanNeighbours beside) {
    float elevation = 0.0;
    int side = 0;
    float _e4 = barchan_height_texel(texel_2, 0);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e33 = side;
            side = (_e33 + 1);
        }
        loop_init = false;
        int _e9 = side;
        if ((_e9 < 2)) {
        } else {
            break;
        }
        {
            int _e16 = side;
            float weight_1 = ((_e16 == 1) ? beside.weight : (1.0 - beside.weight));
            if ((weight_1 != 0.0)) {
                int _e24 = side;
                int azimuth_3 = ((_e24 == 1) ? beside.second : beside.first);
                float _e28 = elevation;
                float _e29 = barchan_curved_towards(ground_4, texel_2, _e4, azimuth_3);
                elevation = (_e28 + (weight_1 * _e29));
            }
        }
    }
    float _e35 = elevation;
    return _e35;
}

float barchan_curved_elevation(vec2 place_7, BarchanTangentLight light, float curvature_1) {
    float elevation_1 = 0.0;
    int tap = 0;
    float _e7 = _group_0_binding_0_fs[0].least;
    BarchanGround _e8 = barchan_ground(curvature_1, light.stretch, _e7);
    BarchanNeighbours _e11 = barchan_neighbours(BARCHAN_HORIZON, light.azimuth);
    vec2 corner = floor(place_7);
    vec2 part_1 = (place_7 - corner);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e45 = tap;
            tap = (_e45 + 1);
        }
        loop_init_1 = false;
        int _e18 = tap;
        if ((_e18 < 4)) {
        } else {
            break;
        }
        {
            int _e21 = tap;
            int _e24 = tap;
            ivec2 offset_1 = ivec2((_e21 & 1), (_e24 >> 1u));
            vec2 weights = mix((vec2(1.0) - part_1), part_1, equal(offset_1, ivec2(1)));
            float _e35 = elevation_1;
            float _e41 = barchan_curved_texel(_e8, (ivec2(corner) + offset_1), _e11);
            elevation_1 = (_e35 + ((weights.x * weights.y) * _e41));
        }
    }
    float _e47 = elevation_1;
    return clamp(_e47, -1.5707963, BARCHAN_GREATEST_ELEVATION);
}

bool barchan_is_below(BarchanTangentLight light_1, float elevation_2) {
    vec2 _e2 = barchan_sine_cosine(elevation_2);
    return ((light_1.height * _e2.y) < (light_1.level * _e2.x));
}

bool barchan_curved_in_shadow(vec2 place_8, BarchanTangentLight light_2, float curvature_2) {
    float _e3 = barchan_curved_elevation(place_8, light_2, curvature_2);
    bool _e4 = barchan_is_below(light_2, _e3);
    return _e4;
}

vec2 barchan_probe_place(vec4 position_1) {
    vec2 _e3 = _group_0_binding_14_fs.place;
    vec2 _e8 = _group_0_binding_14_fs.step_;
    return (_e3 + (floor(position_1.xy) * _e8));
}

void main() {
    vec4 position = gl_FragCoord;
    vec2 _e1 = barchan_probe_place(position);
    vec2 _e5 = _group_0_binding_0_fs[1].extent;
    vec2 _e9 = _group_0_binding_0_fs[1].spacing;
    vec2 extent_2 = (_e5 * _e9);
    vec3 normal_2 = vec3(0.0, 0.0, 1.0);
    vec3 _e17 = _group_0_binding_14_fs.along_u;
    vec3 _e20 = _group_0_binding_14_fs.along_v;
    vec3 _e23 = _group_0_binding_14_fs.light;
    BarchanTangentLight _e24 = barchan_tangent_light(_e17, _e20, normal_2, _e23, extent_2);
    vec3 _e27 = _group_0_binding_14_fs.first_form;
    vec3 _e30 = _group_0_binding_14_fs.second_form;
    float _e32 = barchan_curvature_along(_e27, _e30, _e24.direction);
    float _e33 = barchan_curved_elevation(_e1, _e24, _e32);
    bool _e34 = barchan_is_below(_e24, _e33);
    _fs2p_location0 = vec4(_e33, (_e34 ? 1.0 : 0.0), _e32, _e24.azimuth);
    return;
}

