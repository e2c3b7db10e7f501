// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks for the tests that stay alive in Release, where `assert()` is compiled out.
//
// A failed check is printed and counted, and the program goes on, so that one run tells of all
// failures. A test ends with `return check::result();`. A test without a single check fails.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_CHECK_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_CHECK_H

#include <cmath>
#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

namespace check {

// A check inside a loop may fail a million times: the first few failures say enough.
constexpr std::size_t printed_failures_per_line = 20;

struct Counters
{
  std::size_t checks = 0;
  std::size_t failures = 0;
  std::map<std::pair<std::string, int>, std::size_t> failures_of_line;
};

inline Counters& counters()
{
  static Counters the_counters;
  return the_counters;
}

inline void report_failure(const char* file, int line, const std::string& message)
{
  ++counters().failures;
  const std::size_t failures_here = ++counters().failures_of_line[{file, line}];
  if (failures_here <= printed_failures_per_line)
    std::cerr << file << ":" << line << ": " << message << std::endl;
  if (failures_here == printed_failures_per_line)
    std::cerr << file << ":" << line << ": further failures of this line are only counted" << std::endl;
}

inline void report(bool passed, const char* file, int line, const std::string& message)
{
  ++counters().checks;
  if (!passed)
    report_failure(file, line, message);
}

template <typename T, typename = void>
struct Is_printable : std::false_type
{};

template <typename T>
struct Is_printable<T, std::void_t<decltype(std::declval<std::ostream&>() << std::declval<const T&>())>>
  : std::true_type
{};

template <typename T>
std::string as_text(const T& value)
{
  if constexpr (std::is_enum_v<T>)
    return std::to_string(static_cast<long long>(value));
  else if constexpr (Is_printable<T>::value)
  {
    std::ostringstream out;
    out << std::boolalpha << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
    return out.str();
  }
  else
    return "(not printable)";
}

// `std::size_t` results are compared to literals of type `int` everywhere in the tests; this
// compares their values without the warning on signs, and never takes -1 for a huge number.
template <typename A, typename B>
bool are_equal(const A& a, const B& b)
{
  constexpr bool integers = std::is_integral_v<A> && std::is_integral_v<B> && !std::is_same_v<A, bool> &&
                            !std::is_same_v<B, bool>;
  if constexpr (integers && std::is_signed_v<A> && !std::is_signed_v<B>)
    return a >= 0 && static_cast<std::make_unsigned_t<A>>(a) == b;
  else if constexpr (integers && !std::is_signed_v<A> && std::is_signed_v<B>)
    return b >= 0 && a == static_cast<std::make_unsigned_t<B>>(b);
  else
    return a == b;
}

template <typename A, typename B>
void check_equal(const A& a, const B& b, const char* file, int line, const std::string& expressions)
{
  const bool passed = are_equal(a, b);
  report(passed, file, line,
         passed ? std::string() : expressions + ": " + as_text(a) + " is not " + as_text(b));
}

// Equal infinities are close; a NaN is close to nothing.
inline void check_close(double a,
                        double b,
                        double tolerance,
                        const char* file,
                        int line,
                        const std::string& expressions)
{
  const bool passed = a == b || std::abs(a - b) <= tolerance;
  report(passed, file, line,
         passed ? std::string()
                : expressions + ": " + as_text(a) + " is not within " + as_text(tolerance) + " of " +
                    as_text(b));
}

// What is wrong with how `function()` throws; empty if it throws as expected. The handlers are
// nested because `Exception` may be std::exception itself.
template <typename Exception, typename Function>
std::string problem_with_throwing(Function function, const std::string& part_of_message)
{
  try
  {
    try
    {
      function();
      return "throws nothing";
    }
    catch (const Exception& exception)
    {
      const std::string message = exception.what();
      if (message.find(part_of_message) != std::string::npos)
        return "";
      return "throws \"" + message + "\" without \"" + part_of_message + "\"";
    }
  }
  catch (const std::exception& exception)
  {
    return std::string("throws another exception: ") + exception.what();
  }
  catch (...)
  {
    return "throws something that is no std::exception";
  }
}

template <typename Exception, typename Function>
void check_throws(Function function,
                  const std::string& part_of_message,
                  const char* file,
                  int line,
                  const std::string& expression)
{
  const std::string problem = problem_with_throwing<Exception>(function, part_of_message);
  report(problem.empty(), file, line, expression + " " + problem);
}

template <typename Exception, typename Function>
void check_throws_as(Function function, const char* file, int line, const std::string& expression)
{
  bool throws = false;
  try
  {
    function();
  }
  catch (const Exception&)
  {
    throws = true;
  }
  report(throws, file, line, expression + " does not throw");
}

// The closing line and the exit code of the program: 0 if all checks passed, else 1.
inline int result()
{
  const Counters& all = counters();
  std::cout << all.checks << " checks, " << all.failures << " failures" << std::endl;
  return all.checks > 0 && all.failures == 0 ? 0 : 1;
}

} // namespace check

// `CGAL_CHECK(condition)`. Variadic, so that a condition may hold commas: `CGAL_CHECK(std::is_same_v<A, B>)`.
#define CGAL_CHECK(...)                                                                                       \
  check::report(static_cast<bool>(__VA_ARGS__), __FILE__, __LINE__, #__VA_ARGS__ " is false")

// `CGAL_CHECK_EQUAL(a, b)`: `a == b`; prints both values. Signed and unsigned integers may be mixed.
#define CGAL_CHECK_EQUAL(a, b) check::check_equal(a, b, __FILE__, __LINE__, #a " == " #b)

// `CGAL_CHECK_CLOSE(a, b, tolerance)`: `|a - b| <= tolerance` (absolute); prints all three values.
#define CGAL_CHECK_CLOSE(a, b, tolerance) check::check_close(a, b, tolerance, __FILE__, __LINE__, #a " == " #b)

// `CGAL_CHECK_THROWS(expression, Exception)`: throws an `Exception` or a class derived from it.
#define CGAL_CHECK_THROWS(expression, Exception) CGAL_CHECK_THROWS_WITH(expression, Exception, "")

// The same for an exception that need not derive from `std::exception`.
#define CGAL_CHECK_THROWS_AS(expression, Exception)                                                           \
  check::check_throws_as<Exception>([&]() { static_cast<void>(expression); }, __FILE__, __LINE__, #expression)

// Also checks that the message contains `part_of_message`.
#define CGAL_CHECK_THROWS_WITH(expression, Exception, part_of_message)                                        \
  check::check_throws<Exception>([&]() { static_cast<void>(expression); }, part_of_message, __FILE__,    \
                                 __LINE__, #expression)

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_CHECK_H
