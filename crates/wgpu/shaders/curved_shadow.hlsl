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

struct BarchanNeighbours {
    int first;
    int second;
    float weight;
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
static const uint BARCHAN_HORIZON = 1u;
static const uint BARCHAN_DISTANCE = 2u;
static const float BARCHAN_TURN = 6.2831855;
static const float BARCHAN_NO_HORIZON = -3.4e38;
static const float BARCHAN_CLOSED = 3.4e38;
static const float BARCHAN_GREATEST_ELEVATION = 1.5707963;
static const float BARCHAN_LEAST_COSINE = 7.549789e-8;

cbuffer barchan_tables : register(b0) { BarchanTable barchan_tables[12]; }
Texture2D<float4> barchan_height_texels : register(t2);
Texture2DArray<float4> barchan_horizon_texels : register(t3);
Texture2DArray<float4> barchan_distance_texels : register(t4);
cbuffer barchan_probe : register(b14) { BarchanProbe barchan_probe; }

struct FragmentInput_barchan_probe_curved {
    float4 position_2 : SV_Position;
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
    float sine_2 = (min(size_2.x, size_2.y) / larger);
    const float _e13 = barchan_arctangent(sine_2);
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
    float sine_3 = (((((((-0.00019515296 * square_2) + 0.008332161) * square_2) - 0.16666655) * square_2) * rest) + rest);
    float cosine = ((((((((2.4433157e-5 * square_2) - 0.0013887316) * square_2) + 0.041666646) * square_2) * square_2) - (0.5 * square_2)) + 1.0);
    int turned = (naga_f2i32(quarter) & int(3));
    float2 swapped = (((turned & int(1)) != int(0)) ? float2(cosine, sine_3) : float2(sine_3, cosine));
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
    uint first_2 = barchan_tables[table].first_level;
    float2 _e10 = barchan_tables[table].extent;
    int2 whole = naga_f2i32(_e10);
    int2 extent_1 = max((whole >> ((first_2 + uint(level))).xx), (int(1)).xx);
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

float barchan_horizon_before_transfer(int2 place_3, int layer_2)
{
    const int2 _e4 = barchan_inside(BARCHAN_HORIZON, place_3, int(0));
    float4 _e8 = barchan_horizon_texels.Load(int4(_e4, layer_2, int(0)));
    const float _e10 = barchan_scaled(BARCHAN_HORIZON, _e8.x);
    return _e10;
}

float barchan_horizon_texel(int2 place_4, int layer_3)
{
    const float _e3 = barchan_horizon_before_transfer(place_4, layer_3);
    const float _e4 = barchan_transferred(BARCHAN_HORIZON, _e3);
    return _e4;
}

float barchan_distance_before_transfer(int2 place_5, int layer_4)
{
    const int2 _e4 = barchan_inside(BARCHAN_DISTANCE, place_5, int(0));
    float4 _e8 = barchan_distance_texels.Load(int4(_e4, layer_4, int(0)));
    const float _e10 = barchan_scaled(BARCHAN_DISTANCE, _e8.x);
    return _e10;
}

float barchan_distance_texel(int2 place_6, int layer_5)
{
    const float _e3 = barchan_distance_before_transfer(place_6, layer_5);
    const float _e4 = barchan_transferred(BARCHAN_DISTANCE, _e3);
    return _e4;
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

BarchanNeighbours ConstructBarchanNeighbours(int arg0, int arg1, float arg2) {
    BarchanNeighbours ret = (BarchanNeighbours)0;
    ret.first = arg0;
    ret.second = arg1;
    ret.weight = arg2;
    return ret;
}

BarchanNeighbours barchan_neighbours(uint table_9, float azimuth)
{
    bool local_1 = (bool)0;

    uint _e5 = barchan_tables[table_9].azimuths;
    int count = int(_e5);
    float step_ = barchan_tables[table_9].azimuth_step;
    float _e14 = barchan_tables[table_9].first_azimuth;
    float turns = ((azimuth - _e14) / BARCHAN_TURN);
    float offset = ((turns - floor(turns)) * BARCHAN_TURN);
    if (!((count <= int(1)))) {
        local_1 = (step_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e30 = local_1;
    if (_e30) {
        const BarchanNeighbours barchanneighbours = ConstructBarchanNeighbours(int(0), int(0), 0.0);
        return barchanneighbours;
    }
    float position_3 = (offset / step_);
    float index_1 = floor(position_3);
    float weight = (position_3 - index_1);
    uint _e41 = barchan_tables[table_9].is_circle;
    if ((_e41 != 0u)) {
        int first_3 = naga_mod(naga_f2i32(index_1), count);
        const BarchanNeighbours barchanneighbours_1 = ConstructBarchanNeighbours(first_3, naga_mod(asint(asuint(first_3) + asuint(int(1))), count), weight);
        return barchanneighbours_1;
    }
    int last = asint(asuint(count) - asuint(int(1)));
    float span = (float(last) * step_);
    if ((offset < span)) {
        int first_4 = min(naga_f2i32(index_1), asint(asuint(last) - asuint(int(1))));
        const BarchanNeighbours barchanneighbours_2 = ConstructBarchanNeighbours(first_4, asint(asuint(first_4) + asuint(int(1))), min((position_3 - float(first_4)), 1.0));
        return barchanneighbours_2;
    }
    int end = (((BARCHAN_TURN - offset) <= (offset - span)) ? int(0) : last);
    const BarchanNeighbours barchanneighbours_3 = ConstructBarchanNeighbours(end, end, 0.0);
    return barchanneighbours_3;
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
    bool local_2 = (bool)0;

    float height_4 = dot(towards, normal_1);
    float3 tangent_1 = (towards - (normal_1 * height_4));
    float level_1 = length(tangent_1);
    const float2 _e9 = barchan_texture_step(along_u_3, along_v_3, tangent_1);
    float2 on_grid = (_e9 * extent);
    float grid_length = length(on_grid);
    if ((level_1 > 0.0)) {
        local_2 = (grid_length > 0.0);
    } else {
        local_2 = false;
    }
    bool _e19 = local_2;
    if (!(_e19)) {
        const BarchanTangentLight barchantangentlight = ConstructBarchanTangentLight(height_4, level_1, _e9, 0.0, 1.0);
        return barchantangentlight;
    }
    const float _e24 = barchan_azimuth(on_grid);
    const BarchanTangentLight barchantangentlight_1 = ConstructBarchanTangentLight(height_4, level_1, _e9, _e24, (level_1 / grid_length));
    return barchantangentlight_1;
}

float barchan_mean_curvature(float3 first, float3 second)
{
    float area_squared_1 = ((first.x * first.z) - (first.y * first.y));
    if (!((area_squared_1 > 0.0))) {
        return 0.0;
    }
    return ((((second.x * first.z) - ((2.0 * second.y) * first.y)) + (second.z * first.x)) / (2.0 * area_squared_1));
}

float barchan_curvature_along(float3 first_1, float3 second_1, float2 direction_1)
{
    float larger_1 = max(abs(direction_1.x), abs(direction_1.y));
    if (!((larger_1 > 0.0))) {
        const float _e11 = barchan_mean_curvature(first_1, second_1);
        return _e11;
    }
    float2 step_1 = (direction_1 / (larger_1).xx);
    float3 products = float3((step_1.x * step_1.x), ((2.0 * step_1.x) * step_1.y), (step_1.y * step_1.y));
    float length_squared = dot(first_1, products);
    if (!((length_squared > 0.0))) {
        const float _e30 = barchan_mean_curvature(first_1, second_1);
        return _e30;
    }
    return (dot(second_1, products) / length_squared);
}

float barchan_further_slope(BarchanGround ground, int2 texel, float height, int azimuth_1)
{
    return BARCHAN_NO_HORIZON;
}

BarchanPoint ConstructBarchanPoint(float arg0, float arg1, float arg2) {
    BarchanPoint ret = (BarchanPoint)0;
    ret.sine = arg0;
    ret.cosine = arg1;
    ret.distance_ = arg2;
    return ret;
}

BarchanPoint barchan_point_of(uint table_10, float stored_4, float distance_)
{
    uint _e6 = barchan_tables[table_10].transfer;
    if ((_e6 == 1u)) {
        float sine_4 = clamp(stored_4, -1.0, 1.0);
        const BarchanPoint barchanpoint = ConstructBarchanPoint(sine_4, max(sqrt(((1.0 - sine_4) * (1.0 + sine_4))), BARCHAN_LEAST_COSINE), distance_);
        return barchanpoint;
    }
    const float2 _e24 = barchan_sine_cosine(clamp(stored_4, -1.5707963, BARCHAN_GREATEST_ELEVATION));
    const BarchanPoint barchanpoint_1 = ConstructBarchanPoint(_e24.x, max(_e24.y, BARCHAN_LEAST_COSINE), distance_);
    return barchanpoint_1;
}

BarchanGround ConstructBarchanGround(float arg0, float arg1, float arg2, float arg3) {
    BarchanGround ret = (BarchanGround)0;
    ret.curvature = arg0;
    ret.stretch = arg1;
    ret.lowest = arg2;
    ret.floor_curvature = arg3;
    return ret;
}

BarchanGround barchan_ground(float curvature, float stretch, float lowest)
{
    float widened = (1.0 + (curvature * lowest));
    if (!(((curvature * widened) > 0.0))) {
        const BarchanGround barchanground = ConstructBarchanGround(curvature, stretch, lowest, 0.0);
        return barchanground;
    }
    const BarchanGround barchanground_1 = ConstructBarchanGround(curvature, stretch, lowest, min((curvature / widened), 1e30));
    return barchanground_1;
}

float barchan_sinc(float x, float sine_1)
{
    if ((abs(x) < 0.04)) {
        return (1.0 - ((x * x) / 6.0));
    }
    return (sine_1 / x);
}

float barchan_carried_slope(BarchanGround ground_1, BarchanPoint point_, float height_1)
{
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    float angle_3 = (ground_1.curvature * (ground_1.stretch * point_.distance_));
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
    float run = (point_.cosine * ground_1.stretch);
    float widened_1 = ((run * raised) + (angle_3 * point_.sine));
    if (!((widened_1 > 0.0))) {
        return ((ground_1.curvature > 0.0) ? BARCHAN_NO_HORIZON : BARCHAN_CLOSED);
    }
    const float2 _e46 = barchan_sine_cosine((0.5 * angle_3));
    const float _e50 = barchan_sinc((0.5 * angle_3), _e46.x);
    float rise = ((point_.sine * (1.0 - ((2.0 * _e46.x) * _e46.x))) - (((run * raised) * _e46.x) * _e50));
    return clamp((rise / ((widened_1 * _e50) * _e46.y)), BARCHAN_NO_HORIZON, BARCHAN_CLOSED);
}

float barchan_smooth_slope(BarchanGround ground_2, float height_2)
{
    if ((ground_2.floor_curvature <= 0.0)) {
        return BARCHAN_NO_HORIZON;
    }
    float raised_1 = max((ground_2.floor_curvature * (height_2 - ground_2.lowest)), 0.0);
    return -(sqrt((raised_1 * (2.0 + raised_1))));
}

float barchan_curved_towards(BarchanGround ground_3, int2 texel_1, float height_3, int azimuth_2)
{
    const float _e4 = barchan_horizon_before_transfer(texel_1, azimuth_2);
    const float _e6 = barchan_distance_texel(texel_1, azimuth_2);
    const BarchanPoint _e7 = barchan_point_of(BARCHAN_HORIZON, _e4, _e6);
    const float _e8 = barchan_smooth_slope(ground_3, height_3);
    const float _e9 = barchan_carried_slope(ground_3, _e7, height_3);
    float slope = max(_e8, _e9);
    const float _e11 = barchan_further_slope(ground_3, texel_1, height_3, azimuth_2);
    const float _e13 = barchan_arctangent(max(slope, _e11));
    return _e13;
}

float barchan_curved_texel(BarchanGround ground_4, int2 texel_2, BarchanNeighbours beside)
{
    float elevation = 0.0;
    int side = int(0);

    const float _e4 = barchan_height_texel(texel_2, int(0));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e33 = side;
            side = asint(asuint(_e33) + asuint(int(1)));
        }
        loop_init = false;
        int _e9 = side;
        if ((_e9 < int(2))) {
        } else {
            break;
        }
        {
            int _e16 = side;
            float weight_1 = ((_e16 == int(1)) ? beside.weight : (1.0 - beside.weight));
            if ((weight_1 != 0.0)) {
                int _e24 = side;
                int azimuth_3 = ((_e24 == int(1)) ? beside.second : beside.first);
                float _e28 = elevation;
                const float _e29 = barchan_curved_towards(ground_4, texel_2, _e4, azimuth_3);
                elevation = (_e28 + (weight_1 * _e29));
            }
        }
    }
    float _e35 = elevation;
    return _e35;
}

float barchan_curved_elevation(float2 place_7, BarchanTangentLight light, float curvature_1)
{
    float elevation_1 = 0.0;
    int tap = int(0);

    float _e7 = barchan_tables[0].least;
    const BarchanGround _e8 = barchan_ground(curvature_1, light.stretch, _e7);
    const BarchanNeighbours _e11 = barchan_neighbours(BARCHAN_HORIZON, light.azimuth);
    float2 corner = floor(place_7);
    float2 part_1 = (place_7 - corner);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e45 = tap;
            tap = asint(asuint(_e45) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e18 = tap;
        if ((_e18 < int(4))) {
        } else {
            break;
        }
        {
            int _e21 = tap;
            int _e24 = tap;
            int2 offset_1 = int2((_e21 & int(1)), (_e24 >> 1u));
            float2 weights = ((offset_1 == (int(1)).xx) ? part_1 : ((1.0).xx - part_1));
            float _e35 = elevation_1;
            const float _e41 = barchan_curved_texel(_e8, asint(asuint(naga_f2i32(corner)) + asuint(offset_1)), _e11);
            elevation_1 = (_e35 + ((weights.x * weights.y) * _e41));
        }
    }
    float _e47 = elevation_1;
    return clamp(_e47, -1.5707963, BARCHAN_GREATEST_ELEVATION);
}

bool barchan_is_below(BarchanTangentLight light_1, float elevation_2)
{
    const float2 _e2 = barchan_sine_cosine(elevation_2);
    return ((light_1.height * _e2.y) < (light_1.level * _e2.x));
}

bool barchan_curved_in_shadow(float2 place_8, BarchanTangentLight light_2, float curvature_2)
{
    const float _e3 = barchan_curved_elevation(place_8, light_2, curvature_2);
    const bool _e4 = barchan_is_below(light_2, _e3);
    return _e4;
}

float2 barchan_probe_place(float4 position_1)
{
    float2 _e3 = barchan_probe.place;
    float2 _e8 = barchan_probe.step_;
    return (_e3 + (floor(position_1.xy) * _e8));
}

float4 barchan_probe_vertex(uint index : SV_VertexID) : SV_Position
{
    return float4(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

float4 barchan_probe_curved(FragmentInput_barchan_probe_curved fragmentinput_barchan_probe_curved) : SV_Target0
{
    float4 position = fragmentinput_barchan_probe_curved.position_2;
    const float2 _e1 = barchan_probe_place(position);
    float2 _e5 = barchan_tables[1].extent;
    float2 _e9 = barchan_tables[1].spacing;
    float2 extent_2 = (_e5 * _e9);
    float3 normal_2 = float3(0.0, 0.0, 1.0);
    float3 _e17 = barchan_probe.along_u;
    float3 _e20 = barchan_probe.along_v;
    float3 _e23 = barchan_probe.light;
    const BarchanTangentLight _e24 = barchan_tangent_light(_e17, _e20, normal_2, _e23, extent_2);
    float3 _e27 = barchan_probe.first_form;
    float3 _e30 = barchan_probe.second_form;
    const float _e32 = barchan_curvature_along(_e27, _e30, _e24.direction);
    const float _e33 = barchan_curved_elevation(_e1, _e24, _e32);
    const bool _e34 = barchan_is_below(_e24, _e33);
    return float4(_e33, (_e34 ? 1.0 : 0.0), _e32, _e24.azimuth);
}
