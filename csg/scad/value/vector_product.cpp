#include "csg/scad/value/vector_product.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <vector>

namespace csg::scad {

namespace {

using Elements = std::span<const Value>;

Value mismatch(std::string_view text, std::size_t m, std::size_t n, std::string& problem) {
    problem = fmt::format("{} ({} != {})", text, m, n);
    return {};
}

Value not_rectangular(std::size_t row, std::string& problem) {
    problem = fmt::format("Matrix must be rectangular. Problem at row {}", row);
    return {};
}

Value no_number_in_vector(std::size_t index, std::string& problem) {
    problem = fmt::format("Vector must contain only numbers. Problem at index {}", index);
    return {};
}

Value no_number_in_matrix(std::size_t row, std::size_t column, std::string& problem) {
    problem = fmt::format("Matrix must contain only numbers. Problem at row {}, col {}", row, column);
    return {};
}

/// Both as long.
Value dot(Elements a, Elements b, std::string& problem) {
    note_values(a.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!a[i].is_number() || !b[i].is_number()) {
            problem = fmt::format("undefined operation ({} * {})", type_name(a[i].type()), type_name(b[i].type()));
            return {};
        }
        sum += a[i].number() * b[i].number();
    }
    return sum;
}

/// A row vector times a matrix, which has `v.size()` rows, the first a vector.
Value vector_times_matrix(Elements v, Elements matrix, std::string& problem) {
    const std::size_t columns = matrix[0].elements().size();
    const auto element = [&](std::size_t column) -> Value {
        note_values(matrix.size());
        double sum = 0;
        for (std::size_t row = 0; row < matrix.size(); ++row) {
            if (!matrix[row].is_vector() || matrix[row].elements().size() != columns) {
                return not_rectangular(row, problem);
            }
            const Value& m = matrix[row].elements()[column];
            if (!v[row].is_number()) {
                return no_number_in_vector(row, problem);
            }
            if (!m.is_number()) {
                return no_number_in_matrix(row, column, problem);
            }
            sum += v[row].number() * m.number();
        }
        return sum;
    };
    Value result = Value::list_of(columns, [&](std::size_t i) { return problem.empty() ? element(i) : Value(); });
    return problem.empty() ? result : Value();
}

/// A matrix, its first row a vector as long as `v`, times a column vector.
Value matrix_times_vector(Elements matrix, Elements v, std::string& problem) {
    const auto element = [&](std::size_t row) -> Value {
        if (!matrix[row].is_vector() || matrix[row].elements().size() != v.size()) {
            return not_rectangular(row, problem);
        }
        const Elements numbers = matrix[row].elements();
        note_values(numbers.size());
        double sum = 0;
        for (std::size_t column = 0; column < v.size(); ++column) {
            if (!numbers[column].is_number()) {
                return no_number_in_matrix(row, column, problem);
            }
            if (!v[column].is_number()) {
                return no_number_in_vector(column, problem);
            }
            sum += numbers[column].number() * v[column].number();
        }
        return sum;
    };
    Value result = Value::list_of(matrix.size(), [&](std::size_t i) { return problem.empty() ? element(i) : Value(); });
    return problem.empty() ? result : Value();
}

/// `a` has a vector as long as `b` has rows as its first row.
Value matrix_times_matrix(Elements a, Elements b, std::string& problem) {
    std::vector<Value> result;
    result.reserve(a.size());
    for (std::size_t row = 0; row < a.size(); ++row) {
        const std::size_t length = a[row].is_vector() ? a[row].elements().size() : 0;
        if (length != b.size()) {
            problem = fmt::format(
                "matrix*matrix left operand row length does not match right operand row count ({} != {}) at row {}",
                length, b.size(), row);
            return {};
        }
        result.push_back(vector_times_matrix(a[row].elements(), b, problem));
        if (result.back().is_undef()) {
            problem += fmt::format("\n\twhile processing left operand at row {}", row);
            return {};
        }
    }
    return result;
}

}  // namespace

Value multiply_vectors(const Value& a, const Value& b, std::string& problem) {
    const Elements x = a.elements(), y = b.elements();
    if (x.empty() || y.empty()) {
        problem = "Multiplication is undefined on empty vectors";
        return {};
    }
    const ValueType first = x[0].type(), second = y[0].type();
    if (first == ValueType::Number && second == ValueType::Number) {
        return x.size() == y.size() ? dot(x, y, problem)
                                    : mismatch("vector*vector requires matching lengths", x.size(), y.size(), problem);
    }
    if (first == ValueType::Number && second == ValueType::Vector) {
        return x.size() == y.size() ? vector_times_matrix(x, y, problem)
                                    : mismatch("vector*matrix requires vector length to match matrix row count",
                                               x.size(), y.size(), problem);
    }
    if (first == ValueType::Vector && second == ValueType::Number) {
        const std::size_t columns = x[0].elements().size();
        return columns == y.size() ? matrix_times_vector(x, y, problem)
                                   : mismatch("matrix*vector requires matrix column count to match vector length",
                                              columns, y.size(), problem);
    }
    if (first == ValueType::Vector && second == ValueType::Vector) {
        const std::size_t columns = x[0].elements().size();
        return columns == y.size()
                   ? matrix_times_matrix(x, y, problem)
                   : mismatch("matrix*matrix requires left operand column count to match right operand row count",
                              columns, y.size(), problem);
    }
    problem = fmt::format("undefined vector*vector multiplication where first elements are types {} and {}",
                          type_name(first), type_name(second));
    return {};
}

}  // namespace csg::scad
