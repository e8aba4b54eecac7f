// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/hdf5/hdf5_service.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/results/hdf5/hdf5_file.hpp"
#include "ionskin/results/hdf5/hdf5_protocol.hpp"

#include <hdf5.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ionskin::results {
namespace {

constexpr std::uint64_t most_memory = 2'000'000'000;
/// Largest length of an object's or an attribute's name [bytes].
constexpr std::size_t longest_name = 1u << 16;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool sanitized = false;
#endif

void limit(decltype(RLIMIT_AS) what, std::uint64_t amount) {
  rlimit most{};
  getrlimit(what, &most);
  most.rlim_cur = std::min<rlim_t>(most.rlim_max, amount);
  setrlimit(what, &most);
}

/// Limits the address space of the process to `most_memory` above its current size. Not under
/// sanitizers, which reserve terabytes of addresses.
void limit_memory() {
  std::ifstream stream("/proc/self/statm");
  std::uint64_t pages = 0;
  if (!sanitized && stream >> pages) {
    limit(RLIMIT_AS, pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + most_memory);
  }
}

bool receive(int socket, void* bytes, std::size_t count) {
  char* next = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = recv(socket, next, count, 0);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      return false;
    }
    next += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

bool send(int socket, const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = ::send(socket, next, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) {
      continue;
    }
    if (sent <= 0) {
      return false;
    }
    next += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

class Service {
public:
  Service(int socket, std::span<std::byte> image, std::string name)
      : socket_(socket), image_(image), name_(std::move(name)),
        bytes_(static_cast<double>(image.size())) {}

  int run() {
    Hdf5Request request;
    while (receive(socket_, &request, sizeof(request))) {
      if (request.object_bytes > longest_name || request.name_bytes > longest_name) {
        return 1;
      }
      std::string object(request.object_bytes, '\0'), name(request.name_bytes, '\0');
      if (!receive(socket_, object.data(), object.size()) ||
          !receive(socket_, name.data(), name.size())) {
        return 1;
      }
      bytes_ += static_cast<double>(request.expected_bytes);
      limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::ceil(reading_seconds(bytes_))));
      if (!reply(request, object, name)) {
        return 1;
      }
    }
    return 0;
  }

private:
  bool say(Hdf5State state, const void* bytes = nullptr, std::size_t count = 0) const {
    const Hdf5Answer answer{state, count};
    return send(socket_, &answer, sizeof(answer)) && send(socket_, bytes, count);
  }
  bool say(std::string_view text) const {
    return say(Hdf5State::answered, text.data(), text.size());
  }
  bool say(bool truth) const { return say(Hdf5State::answered, &truth, sizeof(truth)); }
  template <class Number> bool say(const std::vector<Number>& numbers) const {
    return say(Hdf5State::answered, numbers.data(), numbers.size() * sizeof(Number));
  }

  bool reply(const Hdf5Request& request, const std::string& object, const std::string& name) {
    try {
      return answer(request, object, name);
    } catch (const UserError& error) {
      const std::string_view text = error.what();
      return say(Hdf5State::refused, text.data(), text.size());
    } catch (const std::bad_alloc&) {
      return say(Hdf5State::out_of_memory);
    }
  }

  bool answer(const Hdf5Request& request, const std::string& object, const std::string& name) {
    if (!file_) {
      file_ = std::make_unique<Hdf5File>(image_, name_);
      return say(true);
    }
    switch (request.question) {
    case Hdf5Question::plain:
      file_->require_plain();
      return say(true);
    case Hdf5Question::has:
      return say(file_->has(object));
    case Hdf5Question::has_numbers:
      return say(file_->has_numbers(object));
    case Hdf5Question::members:
      return say(std::string_view(joined_texts(file_->members(object))));
    case Hdf5Question::shape: {
      const Hdf5File::Shape shape = file_->shape(object);
      return say(std::vector<std::uint64_t>(shape.begin(), shape.end()));
    }
    case Hdf5Question::numbers:
      return say(file_->read(object));
    case Hdf5Question::text:
      return say(std::string_view(file_->read_text(object)));
    case Hdf5Question::texts:
      return say(std::string_view(joined_texts(file_->read_texts(object))));
    case Hdf5Question::frame:
      file_->read_frame(object, request.frame, frame_);
      return say(frame_);
    case Hdf5Question::text_attribute: {
      const auto text = file_->text_attribute(object, name);
      return text ? say(std::string_view(*text)) : say(Hdf5State::nothing);
    }
    case Hdf5Question::number_attribute: {
      const auto number = file_->number_attribute(object, name);
      return number ? say(std::vector{*number}) : say(Hdf5State::nothing);
    }
    default:
      return false;
    }
  }

  int socket_;
  std::span<std::byte> image_;
  std::string name_;
  double bytes_; ///< size of the file and of all answers so far, for the time limit [bytes]
  std::unique_ptr<Hdf5File> file_;
  std::vector<double> frame_;
};

} // namespace

int serve_hdf5(int socket, int file, const std::string& name) {
  struct stat status {};
  if (fstat(file, &status) != 0) {
    return 1;
  }
  H5open();
  H5PLset_loading_state(0);
  const auto bytes = static_cast<std::size_t>(status.st_size);
  // The mapping is private: writes of the library do not reach the file.
  void* image = bytes == 0 ? nullptr
                           : mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                                  MAP_PRIVATE | MAP_NORESERVE, file, 0);
  if (image == MAP_FAILED) {
    return 1;
  }
  limit_memory();
  limit(RLIMIT_CORE, 0);
  // The process can open no further file, so no link, dataset or filter leads to another one.
  // Sanitizers need a pipe to inspect exceptions.
  limit(RLIMIT_NOFILE, sanitized ? 16 : 0);
  return Service(socket, {static_cast<std::byte*>(image), bytes}, name).run();
}

} // namespace ionskin::results
