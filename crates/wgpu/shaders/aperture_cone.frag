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
const uint BARCHAN_APERTURE_CONE = 7u;

layout(std140) uniform BarchanTables_block_0Fragment { BarchanTable _group_0_binding_0_fs[12]; };

uniform highp sampler2D _group_0_binding_9_fs;

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
    ivec2 extent = max((whole >> uvec2((first + uint(level)))), ivec2(1));
    uint edges = _group_0_binding_0_fs[table].edges;
    ivec2 repeated = (((place % extent) + extent) % extent);
    ivec2 clamped = min(max(place, ivec2(0)), (extent - ivec2(1)));
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

vec4 barchan_aperture_cone_before_transfer(ivec2 place_1, int layer) {
    ivec2 _e4 = barchan_inside(BARCHAN_APERTURE_CONE, place_1, 0);
    vec4 _e7 = texelFetch(_group_0_binding_9_fs, _e4, layer);
    vec4 _e9 = barchan_scaled_4_(BARCHAN_APERTURE_CONE, _e7.xyzw);
    return _e9;
}

vec4 barchan_aperture_cone_texel(ivec2 place_2, int layer_1) {
    vec4 _e3 = barchan_aperture_cone_before_transfer(place_2, layer_1);
    vec4 _e4 = barchan_transferred_4_(BARCHAN_APERTURE_CONE, _e3);
    return _e4;
}

vec4 barchan_aperture_cone_at(vec2 place_3, int layer_2) {
    vec2 _e8 = _group_0_binding_0_fs[7].extent;
    vec2 uv = ((place_3 + vec2(0.5)) / _e8);
    vec4 _e13 = textureLod(_group_0_binding_9_fs, vec2(uv), 0.0);
    vec4 stored_4 = _e13.xyzw;
    vec4 _e17 = barchan_scaled_4_(BARCHAN_APERTURE_CONE, stored_4);
    vec4 _e18 = barchan_transferred_4_(BARCHAN_APERTURE_CONE, _e17);
    return _e18;
}

vec4 barchan_aperture_cone(vec2 place_4) {
    vec4 _e2 = barchan_aperture_cone_at(place_4, 0);
    float size_3 = length(_e2.xyz);
    vec3 axis = ((size_3 > 1e-6) ? (_e2.xyz / vec3(max(size_3, 1e-20))) : vec3(0.0, 0.0, 1.0));
    return vec4(axis, _e2.w);
}

vec2 barchan_probe_place(vec4 position_1) {
    vec2 _e3 = _group_0_binding_14_fs.place;
    vec2 _e8 = _group_0_binding_14_fs.step_;
    return (_e3 + (floor(position_1.xy) * _e8));
}

void main() {
    vec4 position = gl_FragCoord;
    vec2 _e1 = barchan_probe_place(position);
    vec4 _e2 = barchan_aperture_cone(_e1);
    _fs2p_location0 = _e2;
    return;
}

