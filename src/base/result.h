// Results of operations that can fail on bad input. Bad input is a value, never an exception.
//
// An Error becomes one line on stderr: where (file:line or key), what is wrong, what is allowed and
// how to mend it. Broken promises inside our own code throw instead (see check.h).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "base/check.h"

namespace phs {

/// One problem with the input. Empty parts are left out of the line.
struct Error {
  std::string where = {};    ///< file:line, key or argument
  std::string what = {};     ///< what is wrong
  std::string allowed = {};  ///< what would be accepted
  std::string mend = {};     ///< what to do

  /// `where: what; allowed: …; …` on one line, whatever the parts hold.
  std::string Line() const {
    std::string line = where.empty() ? what : where + ": " + what;
    if (!allowed.empty()) line += "; allowed: " + allowed;
    if (!mend.empty()) line += "; " + mend;
    for (char& letter : line) {
      if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) letter = ' ';
    }
    return line;
  }
};

/// Success, or an Error.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return !error_.has_value(); }
  /// The error. @pre !ok()
  const Error& error() const {
    PHS_CHECK(error_.has_value());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

/// A T, or an Error.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : data_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : data_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return std::holds_alternative<T>(data_); }
  /// The value. @pre ok()
  const T& value() const& {
    PHS_CHECK(ok());
    return std::get<T>(data_);
  }
  T& value() & {
    PHS_CHECK(ok());
    return std::get<T>(data_);
  }
  T&& value() && {
    PHS_CHECK(ok());
    return std::get<T>(std::move(data_));
  }
  /// The error. @pre !ok()
  const Error& error() const {
    PHS_CHECK(!ok());
    return std::get<Error>(data_);
  }
  Status status() const { return ok() ? Status() : Status(error()); }

 private:
  std::variant<T, Error> data_;
};

}  // namespace phs
