// UM-Bridge's own client for C++ on one of our analyses: a program of its user.
//
//     umbridge_client HOST MODEL CONFIG NUMBER...
//
// It prints the size of the input, the value and the gradient there, a derivative along the first parameter, the value
// outside of everything, and what the client says of an input that is too long, a line each.

#include "umbridge.h"

#include <cstdio>
#include <string>
#include <vector>

static void print(const std::vector<double>& numbers) {
  for (double number : numbers)
    std::printf("%.17g ", number);
  std::printf("\n");
}

int main(int argc, char** argv) {
  umbridge::HTTPModel model(argv[1], argv[2]);
  const json config = json::parse(argv[3]);
  std::vector<double> point;
  for (int i = 4; i < argc; ++i)
    point.push_back(std::stod(argv[i]));
  std::vector<double> direction(point.size(), 0.0);
  direction[0] = 1.0;
  std::printf("%zu\n", model.GetInputSizes(config)[0]);
  print(model.Evaluate({point}, config)[0]);
  print(model.Gradient(0, 0, {point}, {1.0}, config));
  print(model.ApplyJacobian(0, 0, {point}, direction, config));
  print(model.Evaluate({std::vector<double>(point.size(), 1e9)}, config)[0]);
  point.push_back(0.0);
  try {
    model.Evaluate({point}, config);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
  }
}
