struct BarchanTable {
    float2 extent;
    float2 spacing;
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
    float2 direction;
    float azimuth;
    float stretch;
};

struct BarchanGradients {
    float3 of_u;
    int _pad1_0;
    float3 of_v;
    int _end_pad_0;
};

struct BarchanReliefRay {
    float2 place;
    float2 step_;
    float3 towards;
    float tangent;
    bool is_valid;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct BarchanStart {
    float depth;
    bool is_proven;
    int2 fetches;
};

struct BarchanFound {
    float depth;
    int _pad1_0;
    int2 fetches;
};

struct BarchanReliefExit {
    float depth;
    int _pad1_0;
    int2 next;
};

struct BarchanReliefLeft {
    float outside;
    float inside;
    bool is_within;
    int fetches;
};

struct BarchanProbe {
    float2 place;
    float2 step_;
    float3 light;
    float angular_radius;
    float3 eye;
    float level_distance;
    float3 first_form;
    float tolerance;
    float3 second_form;
    float unused_0_;
    float3 along_u;
    float unused_1_;
    float3 along_v;
    float unused_2_;
};

static const uint BARCHAN_HEIGHT = 0u;
static const uint BARCHAN_HEMISPHERE = 8u;
static const uint BARCHAN_RELAXED_CONE_MAP = 10u;
static const int BARCHAN_STEPS = int(1);
static const int BARCHAN_BISECTIONS = int(10);
static const float BARCHAN_LONGEST_WAY = 65536.0;
static const float BARCHAN_FARTHEST = 16777216.0;
static const float BARCHAN_STEEPEST = 1048576.0;
static const int BARCHAN_MOST_TURNS = int(4096);
static const float BARCHAN_STEP_BACK = 0.015625;
static const float BARCHAN_TAU = 6.2831855;
static const float BARCHAN_LEAST_STEP = 0.0009765625;

cbuffer barchan_tables : register(b0) { BarchanTable barchan_tables[12]; }
SamplerState barchan_sampler : register(s1);
Texture2D<float4> barchan_height_texels : register(t2);
Texture2DArray<float4> barchan_hemisphere_texels : register(t10);
Texture2D<float4> barchan_relaxed_cone_map_texels : register(t12);
cbuffer barchan_probe : register(b14) { BarchanProbe barchan_probe; }

struct FragmentInput_barchan_probe_relief {
    float4 position_3 : SV_Position;
};

struct FragmentInput_barchan_probe_relief_shadow {
    float4 position_4 : SV_Position;
};

float barchan_arcsine(float sine)
{
    float size = min(abs(sine), 1.0);
    bool is_steep = (size > 0.5);
    float square = (is_steep ? (0.5 * (1.0 - size)) : (size * size));
    float root = (is_steep ? sqrt(square) : size);
    float series = (((((((((((0.0421632 * square) + 0.024181312) * square) + 0.045470025) * square) + 0.074953005) * square) + 0.16666752) * square) * root) + root);
    float angle_1 = (is_steep ? (1.5707963 - (2.0 * series)) : series);
    return ((sine < 0.0) ? -(angle_1) : angle_1);
}

float barchan_arctangent(float tangent)
{
    float start = 0.0;
    float part = (float)0;

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

float barchan_azimuth(float2 direction)
{
    float2 size_2 = abs(direction);
    float larger = max(size_2.x, size_2.y);
    if (!((larger > 0.0))) {
        return 0.0;
    }
    float sine_1 = (min(size_2.x, size_2.y) / larger);
    const float _e13 = barchan_arctangent(sine_1);
    float quadrant = ((size_2.y > size_2.x) ? (1.5707964 - _e13) : _e13);
    float half_ = ((direction.x < 0.0) ? (3.1415927 - quadrant) : quadrant);
    return ((direction.y < 0.0) ? -(half_) : half_);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float2 barchan_sine_cosine(float angle)
{
    bool local = (bool)0;

    float quarter = round((angle * 0.63661975));
    float rest = (((angle - (quarter * 1.5703125)) - (quarter * 0.0004837513)) - (quarter * 7.54979e-8));
    float square_2 = (rest * rest);
    float sine_2 = (((((((-0.00019515296 * square_2) + 0.008332161) * square_2) - 0.16666655) * square_2) * rest) + rest);
    float cosine = ((((((((2.4433157e-5 * square_2) - 0.0013887316) * square_2) + 0.041666646) * square_2) * square_2) - (0.5 * square_2)) + 1.0);
    int turned = (naga_f2i32(quarter) & int(3));
    float2 swapped = (((turned & int(1)) != int(0)) ? float2(cosine, sine_2) : float2(sine_2, cosine));
    if (!((turned == int(1)))) {
        local = (turned == int(2));
    } else {
        local = true;
    }
    bool _e65 = local;
    return float2(((turned >= int(2)) ? -(swapped.x) : swapped.x), (_e65 ? -(swapped.y) : swapped.y));
}

int2 barchan_chosen(int2 other, int2 chosen, bool2 is_chosen)
{
    return int2((is_chosen.x ? chosen.x : other.x), (is_chosen.y ? chosen.y : other.y));
}

int2 naga_mod(int2 lhs, int2 rhs) {
    int2 divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

int2 barchan_inside(uint table, int2 place, int level)
{
    uint first = barchan_tables[table].first_level;
    float2 _e10 = barchan_tables[table].extent;
    int2 whole = naga_f2i32(_e10);
    int2 extent_1 = max((whole >> ((first + uint(level))).xx), (int(1)).xx);
    uint edges = barchan_tables[table].edges;
    int2 repeated = naga_mod(asint(asuint(naga_mod(place, extent_1)) + asuint(extent_1)), extent_1);
    int2 clamped = clamp(place, (int(0)).xx, asint(asuint(extent_1) - asuint((int(1)).xx)));
    const int2 _e41 = barchan_chosen(clamped, repeated, bool2(((edges & 1u) != 0u), ((edges & 2u) != 0u)));
    return _e41;
}

float barchan_scaled(uint table_1, float stored)
{
    float _e5 = barchan_tables[table_1].scale;
    float _e10 = barchan_tables[table_1].bias;
    return ((_e5 * stored) + _e10);
}

float2 barchan_scaled_2_(uint table_2, float2 stored_1)
{
    float _e5 = barchan_tables[table_2].scale;
    float _e10 = barchan_tables[table_2].bias;
    return ((_e5 * stored_1) + (_e10).xx);
}

float4 barchan_scaled_4_(uint table_3, float4 stored_2)
{
    float _e5 = barchan_tables[table_3].scale;
    float _e10 = barchan_tables[table_3].bias;
    return ((_e5 * stored_2) + (_e10).xxxx);
}

float2 barchan_scaled_cone(uint table_4, float2 stored_3)
{
    const float _e4 = barchan_scaled(table_4, stored_3.y);
    return float2(stored_3.x, _e4);
}

float barchan_transferred(uint table_5, float number)
{
    uint _e5 = barchan_tables[table_5].transfer;
    switch(_e5) {
        case 1u: {
            const float _e6 = barchan_arcsine(number);
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

float2 barchan_transferred_2_(uint table_6, float2 number_1)
{
    return number_1;
}

float4 barchan_transferred_4_(uint table_7, float4 number_2)
{
    return number_2;
}

float2 barchan_transferred_cone(uint table_8, float2 number_3)
{
    const float _e4 = barchan_transferred(table_8, number_3.y);
    return float2(number_3.x, _e4);
}

float barchan_height_before_transfer(int2 place_1, int layer)
{
    const int2 _e4 = barchan_inside(BARCHAN_HEIGHT, place_1, int(0));
    float4 _e7 = barchan_height_texels.Load(int3(_e4, layer));
    const float _e9 = barchan_scaled(BARCHAN_HEIGHT, _e7.x);
    return _e9;
}

float barchan_height_texel(int2 place_2, int layer_1)
{
    const float _e3 = barchan_height_before_transfer(place_2, layer_1);
    const float _e4 = barchan_transferred(BARCHAN_HEIGHT, _e3);
    return _e4;
}

float barchan_height_at(float2 place_3, int layer_2)
{
    float2 _e8 = barchan_tables[0].extent;
    float2 uv = ((place_3 + (0.5).xx) / _e8);
    float4 _e13 = barchan_height_texels.SampleLevel(barchan_sampler, uv, 0.0);
    float stored_4 = _e13.x;
    const float _e17 = barchan_scaled(BARCHAN_HEIGHT, stored_4);
    const float _e18 = barchan_transferred(BARCHAN_HEIGHT, _e17);
    return _e18;
}

float barchan_hemisphere_before_transfer(int2 place_4, int layer_3)
{
    const int2 _e4 = barchan_inside(BARCHAN_HEMISPHERE, place_4, int(0));
    float4 _e8 = barchan_hemisphere_texels.Load(int4(_e4, layer_3, int(0)));
    const float _e10 = barchan_scaled(BARCHAN_HEMISPHERE, _e8.x);
    return _e10;
}

float barchan_hemisphere_texel(int2 place_5, int layer_4)
{
    const float _e3 = barchan_hemisphere_before_transfer(place_5, layer_4);
    const float _e4 = barchan_transferred(BARCHAN_HEMISPHERE, _e3);
    return _e4;
}

float2 barchan_relaxed_cone_map_before_transfer(int2 place_6, int layer_5)
{
    const int2 _e4 = barchan_inside(BARCHAN_RELAXED_CONE_MAP, place_6, int(0));
    float4 _e7 = barchan_relaxed_cone_map_texels.Load(int3(_e4, layer_5));
    const float2 _e9 = barchan_scaled_cone(BARCHAN_RELAXED_CONE_MAP, _e7.xy);
    return _e9;
}

float2 barchan_relaxed_cone_map_texel(int2 place_7, int layer_6)
{
    const float2 _e3 = barchan_relaxed_cone_map_before_transfer(place_7, layer_6);
    const float2 _e4 = barchan_transferred_cone(BARCHAN_RELAXED_CONE_MAP, _e3);
    return _e4;
}

float2 barchan_relaxed_cone_map_at(float2 place_8, int layer_7)
{
    float2 _e8 = barchan_tables[10].extent;
    float2 uv_1 = ((place_8 + (0.5).xx) / _e8);
    float4 _e13 = barchan_relaxed_cone_map_texels.SampleLevel(barchan_sampler, uv_1, 0.0);
    float2 stored_5 = _e13.xy;
    const float2 _e17 = barchan_scaled_cone(BARCHAN_RELAXED_CONE_MAP, stored_5);
    const float2 _e18 = barchan_transferred_cone(BARCHAN_RELAXED_CONE_MAP, _e17);
    return _e18;
}

BarchanGradients ConstructBarchanGradients(float3 arg0, float3 arg1) {
    BarchanGradients ret = (BarchanGradients)0;
    ret.of_u = arg0;
    ret.of_v = arg1;
    return ret;
}

BarchanGradients barchan_gradients(float3 along_u, float3 along_v)
{
    float3 area = cross(along_u, along_v);
    float area_squared = dot(area, area);
    if (!((area_squared > 0.0))) {
        const BarchanGradients barchangradients = ConstructBarchanGradients((0.0).xxx, (0.0).xxx);
        return barchangradients;
    }
    const BarchanGradients barchangradients_1 = ConstructBarchanGradients((cross(along_v, area) / (area_squared).xxx), (cross(area, along_u) / (area_squared).xxx));
    return barchangradients_1;
}

float2 barchan_texture_step(float3 along_u_1, float3 along_v_1, float3 vector_)
{
    const BarchanGradients _e3 = barchan_gradients(along_u_1, along_v_1);
    return float2(dot(vector_, _e3.of_u), dot(vector_, _e3.of_v));
}

float3 barchan_bump_normal(float3 along_u_2, float3 along_v_2, float3 normal, float2 per_uv)
{
    const BarchanGradients _e4 = barchan_gradients(along_u_2, along_v_2);
    return normalize(((normal - (per_uv.x * _e4.of_u)) - (per_uv.y * _e4.of_v)));
}

BarchanTangentLight ConstructBarchanTangentLight(float arg0, float arg1, float2 arg2, float arg3, float arg4) {
    BarchanTangentLight ret = (BarchanTangentLight)0;
    ret.height = arg0;
    ret.level = arg1;
    ret.direction = arg2;
    ret.azimuth = arg3;
    ret.stretch = arg4;
    return ret;
}

BarchanTangentLight barchan_tangent_light(float3 along_u_3, float3 along_v_3, float3 normal_1, float3 towards, float2 extent)
{
    bool local_1 = (bool)0;

    float height_1 = dot(towards, normal_1);
    float3 tangent_2 = (towards - (normal_1 * height_1));
    float level_1 = length(tangent_2);
    const float2 _e9 = barchan_texture_step(along_u_3, along_v_3, tangent_2);
    float2 on_grid = (_e9 * extent);
    float grid_length = length(on_grid);
    if ((level_1 > 0.0)) {
        local_1 = (grid_length > 0.0);
    } else {
        local_1 = false;
    }
    bool _e19 = local_1;
    if (!(_e19)) {
        const BarchanTangentLight barchantangentlight = ConstructBarchanTangentLight(height_1, level_1, _e9, 0.0, 1.0);
        return barchantangentlight;
    }
    const float _e24 = barchan_azimuth(on_grid);
    const BarchanTangentLight barchantangentlight_1 = ConstructBarchanTangentLight(height_1, level_1, _e9, _e24, (level_1 / grid_length));
    return barchantangentlight_1;
}

float barchan_relief_thickness()
{
    float _e3 = barchan_tables[0].greatest;
    float _e7 = barchan_tables[0].least;
    return (_e3 - _e7);
}

float4 barchan_relief_depths(float4 heights)
{
    const float _e1 = barchan_relief_thickness();
    if (!((_e1 > 0.0))) {
        return (0.0).xxxx;
    }
    float _e10 = barchan_tables[0].greatest;
    return (((_e10).xxxx - heights) / (_e1).xxxx);
}

float barchan_relief_depth(float height)
{
    const float4 _e2 = barchan_relief_depths((height).xxxx);
    return _e2.x;
}

float2 barchan_relief_in_tile(float2 place_9)
{
    float2 extent_2 = barchan_tables[0].extent;
    uint edges_1 = barchan_tables[0].edges;
    bool2 repeats = bool2(((edges_1 & 1u) != 0u), ((edges_1 & 2u) != 0u));
    float2 rest_1 = (place_9 - (floor((place_9 / extent_2)) * extent_2));
    return (repeats ? ((rest_1 < (0.0).xx) ? (rest_1 + extent_2) : rest_1) : place_9);
}

BarchanReliefRay ConstructBarchanReliefRay(float2 arg0, float2 arg1, float3 arg2, float arg3, bool arg4) {
    BarchanReliefRay ret = (BarchanReliefRay)0;
    ret.place = arg0;
    ret.step_ = arg1;
    ret.towards = arg2;
    ret.tangent = arg3;
    ret.is_valid = arg4;
    return ret;
}

BarchanReliefRay barchan_relief_ray(float2 place_10, float3 towards_1)
{
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    float2 spacing = barchan_tables[0].spacing;
    const float _e6 = barchan_relief_thickness();
    float thickness = max(_e6, 0.0);
    float level_2 = length(towards_1.xy);
    float way = (thickness * ((abs(towards_1.x) * spacing.y) + (abs(towards_1.y) * spacing.x)));
    if ((way <= (((BARCHAN_LONGEST_WAY * spacing.x) * spacing.y) * towards_1.z))) {
        local_2 = (level_2 <= (BARCHAN_STEEPEST * towards_1.z));
    } else {
        local_2 = false;
    }
    bool is_short = local_2;
    bool is_near = all((abs(place_10) <= (16777216.0).xx));
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
        const BarchanReliefRay barchanreliefray = ConstructBarchanReliefRay((0.0).xx, (0.0).xx, float3(0.0, 0.0, 1.0), 0.0, false);
        return barchanreliefray;
    }
    float run = (thickness / towards_1.z);
    float2 step_1 = (float2((-(run) * towards_1.x), (run * towards_1.y)) / spacing);
    const float2 _e74 = barchan_relief_in_tile(place_10);
    const BarchanReliefRay barchanreliefray_1 = ConstructBarchanReliefRay(_e74, step_1, towards_1, (level_2 / towards_1.z), true);
    return barchanreliefray_1;
}

BarchanReliefRay barchan_relief_ray_through(float2 place_11, float depth, float3 towards_2)
{
    const BarchanReliefRay _e3 = barchan_relief_ray(place_11, towards_2);
    if (!(_e3.is_valid)) {
        const BarchanReliefRay barchanreliefray_2 = _e3;
        return barchanreliefray_2;
    }
    const BarchanReliefRay _e10 = barchan_relief_ray((_e3.place - (depth * _e3.step_)), towards_2);
    const BarchanReliefRay barchanreliefray_3 = _e10;
    return barchanreliefray_3;
}

float2 barchan_relief_at(BarchanReliefRay ray, float depth_1)
{
    return (ray.place + (depth_1 * ray.step_));
}

float barchan_relief_way(BarchanReliefRay ray_1)
{
    return max(abs(ray_1.step_.x), abs(ray_1.step_.y));
}

float barchan_relief_way_ahead(BarchanReliefRay ray_2, float start_1)
{
    const float _e7 = barchan_relief_way(ray_2);
    return (((start_1 > 0.0) ? 0.03125 : 0.25) * _e7);
}

int2 barchan_relief_cell(BarchanReliefRay ray_3, float depth_2)
{
    const float2 _e2 = barchan_relief_at(ray_3, depth_2);
    return naga_f2i32(((ray_3.step_ < (0.0).xx) ? (ceil(_e2) - (1.0).xx) : floor(_e2)));
}

int2 barchan_relief_cell_of(BarchanReliefRay ray_4, int2 low, int2 high, float depth_3)
{
    const int2 _e4 = barchan_relief_cell(ray_4, depth_3);
    return clamp(_e4, low, asint(asuint(high) - asuint((int(1)).xx)));
}

BarchanReliefExit ConstructBarchanReliefExit(float arg0, int2 arg1) {
    BarchanReliefExit ret = (BarchanReliefExit)0;
    ret.depth = arg0;
    ret.next = arg1;
    return ret;
}

BarchanReliefExit barchan_relief_exit(BarchanReliefRay ray_5, int2 low_1, int2 high_1, float start_2)
{
    int2 next = (int2)0;

    bool2 moves = (ray_5.step_ != (0.0).xx);
    const int2 _e12 = barchan_chosen(low_1, high_1, (ray_5.step_ > (0.0).xx));
    float2 ends = float2(_e12);
    float2 borders = (moves ? ((ends - ray_5.place) / (moves ? ray_5.step_ : (1.0).xx)) : (1e30).xx);
    float depth_8 = min(max(min(borders.x, borders.y), start_2), 1.0);
    const int2 _e30 = barchan_relief_cell_of(ray_5, low_1, high_1, depth_8);
    next = _e30;
    const int2 _e39 = barchan_chosen(high_1, asint(asuint(low_1) - asuint((int(1)).xx)), (ray_5.step_ < (0.0).xx));
    if ((borders.x <= borders.y)) {
        next.x = _e39.x;
    } else {
        next.y = _e39.y;
    }
    int2 _e47 = next;
    const BarchanReliefExit barchanreliefexit = ConstructBarchanReliefExit(depth_8, _e47);
    return barchanreliefexit;
}

float4 barchan_relief_corners(int2 cell)
{
    const float _e2 = barchan_height_texel(cell, int(0));
    const float _e8 = barchan_height_texel(asint(asuint(cell) + asuint(int2(int(1), int(0)))), int(0));
    const float _e14 = barchan_height_texel(asint(asuint(cell) + asuint(int2(int(0), int(1)))), int(0));
    const float _e20 = barchan_height_texel(asint(asuint(cell) + asuint(int2(int(1), int(1)))), int(0));
    const float4 _e22 = barchan_relief_depths(float4(_e2, _e8, _e14, _e20));
    return _e22;
}

float barchan_relief_twist(float4 corners)
{
    return ((corners.x - corners.y) + (corners.w - corners.z));
}

float barchan_relief_cell_gap(BarchanReliefRay ray_6, int2 cell_1, float4 corners_1, float depth_4)
{
    float2 place_13 = ((ray_6.place - float2(cell_1)) + (depth_4 * ray_6.step_));
    float plane = ((corners_1.x + ((corners_1.y - corners_1.x) * place_13.x)) + ((corners_1.z - corners_1.x) * place_13.y));
    const float _e23 = barchan_relief_twist(corners_1);
    return ((plane + ((_e23 * place_13.x) * place_13.y)) - depth_4);
}

float barchan_relief_gap(BarchanReliefRay ray_7, float depth_5)
{
    const float2 _e2 = barchan_relief_at(ray_7, depth_5);
    int2 cell_3 = naga_f2i32(floor(_e2));
    const float4 _e5 = barchan_relief_corners(cell_3);
    const float _e6 = barchan_relief_cell_gap(ray_7, cell_3, _e5, depth_5);
    return _e6;
}

float barchan_relief_first_zero(float g0_, float g1_, float c)
{
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;
    bool local_7 = (bool)0;
    float s = 1.0;
    bool local_8 = (bool)0;

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

float barchan_relief_hit(BarchanReliefRay ray_8, int2 cell_2, float4 corners_2, float start_3, float end)
{
    float part_3 = (end - start_3);
    const float _e6 = barchan_relief_twist(corners_2);
    float twist = ((_e6 * (part_3 * ray_8.step_.x)) * (part_3 * ray_8.step_.y));
    const float _e15 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, start_3);
    const float _e16 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, end);
    const float _e17 = barchan_relief_first_zero(_e15, _e16, twist);
    return ((_e17 < 0.0) ? -1.0 : (start_3 + (_e17 * part_3)));
}

BarchanReliefLeft ConstructBarchanReliefLeft(float arg0, float arg1, bool arg2, int arg3) {
    BarchanReliefLeft ret = (BarchanReliefLeft)0;
    ret.outside = arg0;
    ret.inside = arg1;
    ret.is_within = arg2;
    ret.fetches = arg3;
    return ret;
}

BarchanReliefLeft barchan_relief_leave(BarchanReliefRay ray_9, BarchanStart start_4, float step_)
{
    bool local_9 = (bool)0;
    float inside = (float)0;
    int fetches = int(1);

    float depth_9 = ((start_4.depth > 0.0) ? min(start_4.depth, 1.0) : 0.0);
    if (!(start_4.is_proven)) {
        local_9 = (depth_9 == 0.0);
    } else {
        local_9 = true;
    }
    bool _e18 = local_9;
    if (_e18) {
        const BarchanReliefLeft barchanreliefleft = ConstructBarchanReliefLeft(depth_9, depth_9, false, int(0));
        return barchanreliefleft;
    }
    const float _e22 = barchan_relief_gap(ray_9, depth_9);
    if ((_e22 > 0.0)) {
        const BarchanReliefLeft barchanreliefleft_1 = ConstructBarchanReliefLeft(depth_9, depth_9, false, int(1));
        return barchanreliefleft_1;
    }
    inside = depth_9;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e48 = fetches;
            fetches = asint(asuint(_e48) + asuint(int(1)));
        }
        loop_init = false;
        int _e31 = fetches;
        if ((_e31 <= BARCHAN_MOST_TURNS)) {
        } else {
            break;
        }
        {
            float _e34 = inside;
            float outside_2 = (_e34 - step_);
            if ((outside_2 <= 0.0)) {
                break;
            }
            const float _e38 = barchan_relief_gap(ray_9, outside_2);
            if ((_e38 > 0.0)) {
                float _e41 = inside;
                int _e43 = fetches;
                const BarchanReliefLeft barchanreliefleft_2 = ConstructBarchanReliefLeft(outside_2, _e41, true, asint(asuint(_e43) + asuint(int(1))));
                return barchanreliefleft_2;
            }
            inside = outside_2;
        }
    }
    float _e50 = inside;
    int _e52 = fetches;
    const BarchanReliefLeft barchanreliefleft_3 = ConstructBarchanReliefLeft(0.0, _e50, true, _e52);
    return barchanreliefleft_3;
}

int barchan_relief_ring(float tangent_1)
{
    bool local_10 = (bool)0;
    float part_1 = (float)0;

    uint _e4 = barchan_tables[8].rings;
    float rings = float(_e4);
    float greatest = barchan_tables[8].max_tangent;
    if ((tangent_1 >= 0.0)) {
        local_10 = (tangent_1 < greatest);
    } else {
        local_10 = false;
    }
    bool _e16 = local_10;
    if (!(_e16)) {
        return int(-1);
    }
    part_1 = sqrt((tangent_1 / greatest));
    uint _e25 = barchan_tables[8].ring_spacing;
    if ((_e25 == 1u)) {
        const float _e28 = barchan_arctangent(tangent_1);
        float _e32 = barchan_tables[8].max_polar;
        part_1 = (_e28 / _e32);
    }
    float _e34 = part_1;
    return naga_f2i32(min(floor((_e34 * rings)), (rings - 1.0)));
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int barchan_relief_azimuth_cell(float azimuth)
{
    bool local_11 = (bool)0;
    bool local_12 = (bool)0;

    uint _e4 = barchan_tables[8].azimuths;
    int count = int(_e4);
    float step_2 = barchan_tables[8].azimuth_step;
    float _e13 = barchan_tables[8].first_azimuth;
    float turns = ((azimuth - _e13) / BARCHAN_TAU);
    float offset = ((turns - floor(turns)) * BARCHAN_TAU);
    float span = (float(asint(asuint(count) - asuint(int(1)))) * step_2);
    if ((step_2 > 0.0)) {
        uint _e32 = barchan_tables[8].is_circle;
        if (!((_e32 != 0u))) {
            local_12 = (offset < span);
        } else {
            local_12 = true;
        }
        bool _e40 = local_12;
        local_11 = _e40;
    } else {
        local_11 = false;
    }
    bool _e42 = local_11;
    if (_e42) {
        return naga_mod(naga_f2i32(((offset / step_2) + 0.5)), max(count, int(1)));
    }
    float beyond_last = (offset - span);
    float before_first = (BARCHAN_TAU - offset);
    int nearer_end = ((beyond_last <= before_first) ? asint(asuint(count) - asuint(int(1))) : int(0));
    return ((min(beyond_last, before_first) <= (0.5 * step_2)) ? nearer_end : int(-1));
}

int2 barchan_relief_direction_cell(BarchanReliefRay ray_10)
{
    const int _e2 = barchan_relief_ring(ray_10.tangent);
    if ((ray_10.tangent <= 0.0)) {
        return int2(_e2, int(0));
    }
    const float _e10 = barchan_azimuth(ray_10.towards.xy);
    const int _e11 = barchan_relief_azimuth_cell(_e10);
    return int2(_e2, _e11);
}

float barchan_relief_ring_edge(int ring)
{
    uint _e5 = barchan_tables[8].rings;
    float part_4 = (float(ring) / float(_e5));
    uint _e11 = barchan_tables[8].ring_spacing;
    if ((_e11 == 1u)) {
        float _e17 = barchan_tables[8].max_polar;
        const float2 _e19 = barchan_sine_cosine((part_4 * _e17));
        return (_e19.x / _e19.y);
    }
    float _e27 = barchan_tables[8].max_tangent;
    return ((part_4 * part_4) * _e27);
}

float2 barchan_relief_azimuth_direction(int index_1)
{
    float _e4 = barchan_tables[8].first_azimuth;
    float _e9 = barchan_tables[8].azimuth_step;
    float azimuth_1 = (_e4 + (float(index_1) * _e9));
    const float2 _e18 = barchan_sine_cosine((azimuth_1 - (round((azimuth_1 / BARCHAN_TAU)) * BARCHAN_TAU)));
    return _e18.yx;
}

BarchanStart ConstructBarchanStart(float arg0, bool arg1, int2 arg2) {
    BarchanStart ret = (BarchanStart)0;
    ret.depth = arg0;
    ret.is_proven = arg1;
    ret.fetches = arg2;
    return ret;
}

BarchanStart barchan_relief_start(BarchanReliefRay ray_11)
{
    bool local_13 = (bool)0;
    bool local_14 = (bool)0;

    BarchanStart top = ConstructBarchanStart(0.0, true, (int(0)).xx);
    const int2 _e6 = barchan_relief_direction_cell(ray_11);
    const float2 _e11 = barchan_relief_in_tile((ray_11.place + (0.5).xx));
    float2 size_3 = barchan_tables[0].extent;
    if (!(any((_e6 < (int(0)).xx)))) {
        local_13 = any((_e11 < (0.0).xx));
    } else {
        local_13 = true;
    }
    bool _e28 = local_13;
    if (!(_e28)) {
        local_14 = any((_e11 > size_3));
    } else {
        local_14 = true;
    }
    bool _e35 = local_14;
    if (_e35) {
        const BarchanStart barchanstart = top;
        return barchanstart;
    }
    float2 count_1 = barchan_tables[8].extent;
    int2 texel = min(naga_f2i32(((_e11 / size_3) * count_1)), asint(asuint(naga_f2i32(count_1)) - asuint((int(1)).xx)));
    uint _e52 = barchan_tables[8].azimuths;
    int layer_8 = asint(asuint(asint(asuint(_e6.x) * asuint(int(_e52)))) + asuint(_e6.y));
    const float _e57 = barchan_hemisphere_texel(texel, layer_8);
    uint _e61 = barchan_tables[8].depth_mode;
    if ((_e61 == 2u)) {
        const BarchanStart barchanstart_1 = ConstructBarchanStart(_e57, true, int2(int(0), int(1)));
        return barchanstart_1;
    }
    float2 level_3 = (ray_11.towards.xy / (ray_11.towards.z).xx);
    const float _e76 = barchan_relief_ring_edge(_e6.x);
    const float2 _e78 = barchan_relief_azimuth_direction(_e6.y);
    float stored_6 = (_e76 * dot(_e78, level_3));
    const BarchanStart barchanstart_2 = ConstructBarchanStart(clamp(((_e57 * (1.0 + stored_6)) / (1.0 + dot(level_3, level_3))), 0.0, 1.0), false, int2(int(0), int(1)));
    return barchanstart_2;
}

float barchan_relief_sampled_gap(BarchanReliefRay ray_12, float depth_6)
{
    const float2 _e2 = barchan_relief_at(ray_12, depth_6);
    const float _e4 = barchan_height_at(_e2, int(0));
    const float _e5 = barchan_relief_depth(_e4);
    return (_e5 - depth_6);
}

float barchan_relief_bisect(BarchanReliefRay ray_13, float before, float behind)
{
    float outside = (float)0;
    float inside_1 = (float)0;
    int k = int(0);

    outside = before;
    inside_1 = behind;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e19 = k;
            k = asint(asuint(_e19) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e7 = k;
        if ((_e7 < BARCHAN_BISECTIONS)) {
        } else {
            break;
        }
        {
            float _e10 = outside;
            float _e11 = inside_1;
            float middle = (0.5 * (_e10 + _e11));
            const float _e15 = barchan_relief_sampled_gap(ray_13, middle);
            if ((_e15 > 0.0)) {
                outside = middle;
            } else {
                inside_1 = middle;
            }
        }
    }
    float _e21 = outside;
    float _e22 = inside_1;
    return (0.5 * (_e21 + _e22));
}

float barchan_relief_cone_step(BarchanReliefRay ray_14, float gap, float ratio)
{
    float part_2 = 1.0;
    bool local_15 = (bool)0;

    if ((ray_14.tangent > 0.0)) {
        part_2 = ((ratio > 0.0) ? (ratio / (ray_14.tangent + ratio)) : 0.0);
    }
    float _e15 = part_2;
    if ((gap > 0.0)) {
        float _e23 = part_2;
        local_15 = (_e23 > 0.0);
    } else {
        local_15 = false;
    }
    bool _e27 = local_15;
    return (_e27 ? min((gap * _e15), 1.0) : 0.0);
}

BarchanFound ConstructBarchanFound(float arg0, int2 arg1) {
    BarchanFound ret = (BarchanFound)0;
    ret.depth = arg0;
    ret.fetches = arg1;
    return ret;
}

BarchanFound barchan_relief_search(BarchanReliefRay ray_15, BarchanStart start_5)
{
    int2 fetches_1 = (int2)0;
    float outside_1 = (float)0;
    float inside_2 = (float)0;
    int turn = int(0);
    bool local_16 = (bool)0;

    const BarchanReliefLeft _e3 = barchan_relief_leave(ray_15, start_5, BARCHAN_STEP_BACK);
    fetches_1 = asint(asuint(start_5.fetches) + asuint(int2(_e3.fetches, int(0))));
    outside_1 = _e3.outside;
    inside_2 = _e3.inside;
    if (!(_e3.is_within)) {
        float _e16 = outside_1;
        inside_2 = _e16;
        bool loop_init_2 = true;
        while(true) {
            if (!loop_init_2) {
                int _e50 = turn;
                turn = asint(asuint(_e50) + asuint(int(1)));
            }
            loop_init_2 = false;
            int _e19 = turn;
            if ((_e19 < BARCHAN_MOST_TURNS)) {
                float _e24 = inside_2;
                local_16 = (_e24 < 1.0);
            } else {
                local_16 = false;
            }
            bool _e28 = local_16;
            if (_e28) {
            } else {
                break;
            }
            {
                int _e31 = fetches_1.y;
                fetches_1.y = asint(asuint(_e31) + asuint(int(1)));
                float _e33 = inside_2;
                const float2 _e34 = barchan_relief_at(ray_15, _e33);
                const float2 _e36 = barchan_relaxed_cone_map_at(_e34, int(0));
                float _e38 = inside_2;
                float gap_1 = (_e36.x - _e38);
                if ((gap_1 <= 0.0)) {
                    break;
                }
                float _e42 = inside_2;
                outside_1 = _e42;
                float _e43 = inside_2;
                const float _e45 = barchan_relief_cone_step(ray_15, gap_1, _e36.y);
                inside_2 = (_e43 + max(_e45, BARCHAN_LEAST_STEP));
            }
        }
        float _e52 = inside_2;
        inside_2 = min(_e52, 1.0);
    }
    float _e55 = outside_1;
    float _e56 = inside_2;
    const float _e57 = barchan_relief_bisect(ray_15, _e55, _e56);
    int2 _e58 = fetches_1;
    const BarchanFound barchanfound = ConstructBarchanFound(_e57, asint(asuint(_e58) + asuint(int2(int(10), int(0)))));
    return barchanfound;
}

BarchanFound barchan_relief_find(BarchanReliefRay ray_16)
{
    if (!(ray_16.is_valid)) {
        const BarchanFound barchanfound_1 = ConstructBarchanFound(0.0, (int(0)).xx);
        return barchanfound_1;
    }
    const BarchanStart _e7 = barchan_relief_start(ray_16);
    const BarchanFound _e8 = barchan_relief_search(ray_16, _e7);
    const BarchanFound barchanfound_2 = _e8;
    return barchanfound_2;
}

float2 barchan_probe_place(float4 position_2)
{
    float2 _e3 = barchan_probe.place;
    float2 _e8 = barchan_probe.step_;
    return (_e3 + (floor(position_2.xy) * _e8));
}

bool barchan_relief_in_shadow(float2 place_12, float depth_7, float3 towards_3, float tolerance)
{
    bool local_17 = (bool)0;

    const BarchanReliefRay _e4 = barchan_relief_ray_through(place_12, depth_7, towards_3);
    if (!(_e4.is_valid)) {
        return true;
    }
    float clear = (depth_7 - tolerance);
    const BarchanStart _e9 = barchan_relief_start(_e4);
    if (_e9.is_proven) {
        local_17 = (_e9.depth >= clear);
    } else {
        local_17 = false;
    }
    bool _e16 = local_17;
    if (_e16) {
        return false;
    }
    const BarchanFound _e18 = barchan_relief_search(_e4, _e9);
    return (_e18.depth < clear);
}

float4 barchan_probe_vertex(uint index : SV_VertexID) : SV_Position
{
    return float4(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

float4 barchan_probe_relief(FragmentInput_barchan_probe_relief fragmentinput_barchan_probe_relief) : SV_Target0
{
    float4 position = fragmentinput_barchan_probe_relief.position_3;
    const float2 _e1 = barchan_probe_place(position);
    float3 _e4 = barchan_probe.eye;
    const BarchanReliefRay _e5 = barchan_relief_ray(_e1, _e4);
    if (!(_e5.is_valid)) {
        return float4(-1.0, 0.0, 0.0, 0.0);
    }
    const BarchanStart _e13 = barchan_relief_start(_e5);
    const BarchanFound _e14 = barchan_relief_search(_e5, _e13);
    return float4(_e14.depth, float2(_e14.fetches), _e13.depth);
}

float4 barchan_probe_relief_shadow(FragmentInput_barchan_probe_relief_shadow fragmentinput_barchan_probe_relief_shadow) : SV_Target0
{
    float4 position_1 = fragmentinput_barchan_probe_relief_shadow.position_4;
    const float2 _e1 = barchan_probe_place(position_1);
    float3 _e4 = barchan_probe.eye;
    const BarchanReliefRay _e5 = barchan_relief_ray(_e1, _e4);
    const BarchanFound _e6 = barchan_relief_find(_e5);
    float depth_10 = _e6.depth;
    const float2 _e8 = barchan_relief_at(_e5, depth_10);
    float3 _e11 = barchan_probe.light;
    float _e14 = barchan_probe.tolerance;
    const bool _e15 = barchan_relief_in_shadow(_e8, depth_10, _e11, _e14);
    return float4(depth_10, (_e15 ? 1.0 : 0.0), 0.0, 0.0);
}
