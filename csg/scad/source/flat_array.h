// An array that grows by realloc: of large ones the kernel moves the pages, so nothing is copied.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>

namespace csg::scad {

template <typename T>
class FlatArray {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    FlatArray() = default;
    ~FlatArray() { std::free(data_); }
    FlatArray(FlatArray&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)),
          size_(std::exchange(other.size_, 0)),
          capacity_(std::exchange(other.capacity_, 0)) {}
    FlatArray& operator=(FlatArray&& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }

    void push_back(const T& value) {
        if (size_ == capacity_) {
            const T copy = value;  // It may lie in this array.
            reserve(std::max<std::size_t>(64, 2 * capacity_));
            data_[size_++] = copy;
        } else {
            data_[size_++] = value;
        }
    }
    /// Invalidates references, as push_back does.
    void reserve(std::size_t capacity) {
        if (capacity <= capacity_) {
            return;
        }
        void* const moved = std::realloc(static_cast<void*>(data_), capacity * sizeof(T));
        if (moved == nullptr) {
            throw std::bad_alloc();
        }
        data_ = static_cast<T*>(moved);
        capacity_ = capacity;
    }
    template <typename Iterator>
    void append(Iterator first, Iterator last) {
        for (; first != last; ++first) {
            push_back(*first);
        }
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t capacity() const { return capacity_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] T* data() { return data_; }
    [[nodiscard]] const T* data() const { return data_; }
    [[nodiscard]] T& operator[](std::size_t i) { return data_[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
    [[nodiscard]] T* begin() { return data_; }
    [[nodiscard]] T* end() { return data_ + size_; }
    [[nodiscard]] const T* begin() const { return data_; }
    [[nodiscard]] const T* end() const { return data_ + size_; }

  private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace csg::scad
