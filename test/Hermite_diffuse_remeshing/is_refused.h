#ifndef IS_REFUSED_H
#define IS_REFUSED_H

#include <stdexcept>

// Does an action refuse what it was given?
template <typename Action>
bool is_refused(const Action& action)
{
  try { action(); }
  catch(const std::invalid_argument&) { return true; }
  return false;
}

#endif // IS_REFUSED_H
