#ifndef FIND_VALUE_H
#define FIND_VALUE_H

#include <cmath>

// Finds the value for which `number_of_faces(value)` is as wanted; it falls with the value, about with a power.
template <typename NumberOfFaces>
double find_value(double value, const double wanted, const double power, const NumberOfFaces& number_of_faces)
{
  constexpr double tolerance = 0.03;
  constexpr int maximum_number_of_trials = 5;
  for(int i = 0; i < maximum_number_of_trials; ++i)
  {
    const double ratio = number_of_faces(value) / wanted;
    if(std::abs(ratio - 1.) < tolerance)
      break;
    value *= std::pow(ratio, 1. / power);
  }
  return value;
}

#endif // FIND_VALUE_H
