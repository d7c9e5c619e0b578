/* Two binaries from a running server, in C:
 *     cc waveforms.c -o waveforms $(pkg-config --cflags --libs libcurl msgpack)
 *     ./waveforms http://127.0.0.1:8000
 */
#include <curl/curl.h>
#include <msgpack.h>
#include <stdio.h>
#include <string.h>

static const char QUESTION[] = /* JSON is as good as MessagePack for what is asked; the answer is in MessagePack */
    "{\"parameters\": {\"mass_ratio\": 1.2, \"lambda_1\": 400, \"lambda_2\": [600, 700], \"chi_1\": 0.01, \"chi_2\": 0,"
    " \"distance_mpc\": 40, \"inclination\": 2.5, \"total_mass\": 2.76},"
    " \"grid\": {\"f_min\": 20, \"f_max\": 2048, \"delta_f\": 0.25}}";

static size_t append(char *data, size_t size, size_t count, void *body)
{
    return msgpack_sbuffer_write(body, data, size * count) == 0 ? size * count : 0;
}

static const msgpack_object *field(const msgpack_object *map, const char *name)
{
    for (uint32_t i = 0; map && map->type == MSGPACK_OBJECT_MAP && i < map->via.map.size; i++) {
        const msgpack_object_str *key = &map->via.map.ptr[i].key.via.str;
        if (key->size == strlen(name) && memcmp(key->ptr, name, key->size) == 0) return &map->via.map.ptr[i].val;
    }
    return NULL;
}

int main(int argc, char **argv)
{
    char url[512];
    snprintf(url, sizeof url, "%s/v1/models/default/waveforms", argc > 1 ? argv[1] : "http://127.0.0.1:8000");
    msgpack_sbuffer body;
    msgpack_sbuffer_init(&body);
    struct curl_slist *headers = curl_slist_append(NULL, "Content-Type: application/json");
    headers = curl_slist_append(headers, "Accept: application/msgpack");
    CURL *curl = curl_easy_init();
    curl_easy_setopt(curl, CURLOPT_URL, url);
    curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers);
    curl_easy_setopt(curl, CURLOPT_POSTFIELDS, QUESTION);
    curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, append);
    curl_easy_setopt(curl, CURLOPT_WRITEDATA, &body);
    long status = 0;
    CURLcode failed = curl_easy_perform(curl);
    curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &status);
    if (failed || status != 200) return fprintf(stderr, "%ld %.*s\n", status, (int)body.size, body.data), 1;

    msgpack_unpacked answer;
    msgpack_unpacked_init(&answer);
    if (msgpack_unpack_next(&answer, body.data, body.size, NULL) != MSGPACK_UNPACK_SUCCESS) return 1;
    const msgpack_object *h = field(&answer.data, "h_plus"), *shape = field(h, "shape"), *data = field(h, "data");
    if (!shape || !data) return 1;
    for (uint64_t row = 0, columns = shape->via.array.ptr[1].via.u64; row < shape->via.array.ptr[0].via.u64; row++) {
        double value[2]; /* "<c16": little endian, real and imaginary part */
        memcpy(value, data->via.bin.ptr + 16 * (row * columns + columns - 1000), sizeof value);
        printf("%d %.17g %.17g\n", (int)row, value[0], value[1]);
    }
}
