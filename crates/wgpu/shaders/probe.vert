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
const uint BARCHAN_HEIGHT = 0u;


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

vec2 barchan_transferred_2_(uint table_6, vec2 number_1) {
    return number_1;
}

vec4 barchan_transferred_4_(uint table_7, vec4 number_2) {
    return number_2;
}

void main() {
    uint index = uint(gl_VertexID);
    gl_Position = vec4(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
    gl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);
    return;
}

