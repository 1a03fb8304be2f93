/* A table over station or sleeper number, between its knots. */
#include "formats/yaml.h"

double yaml_table_at(const struct yaml_table *t, double station, double number)
{
    double x = t->by_number ? number : station;
    int64_t i = 0;

    if (x <= t->at[0] || t->n == 1)
        return t->value[0];
    if (x >= t->at[t->n - 1])
        return t->value[t->n - 1];
    while (x >= t->at[i + 1])
        i++;
    return t->value[i] + (t->value[i + 1] - t->value[i]) * (x - t->at[i]) / (t->at[i + 1] - t->at[i]);
}
