// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>

namespace ionskin::apps::studio::limits {

// Everything that a page or a stranger could make large is bounded here.

inline constexpr std::size_t head = 32u << 10; ///< of a request: its lines before the body [bytes]
inline constexpr std::size_t headers = 100;    ///< of a request
inline constexpr std::size_t body = 4u << 20;  ///< of a request [bytes]
inline constexpr std::size_t upload = 16u << 20; ///< of a measured CSV file [bytes]
inline constexpr std::size_t bodies = 64u << 20; ///< of all requests at once [bytes]
inline constexpr std::size_t connections = 128;  ///< whose requests are read at once
inline constexpr std::size_t workers = 16;       ///< requests that are answered at once
inline constexpr std::size_t waiting = 256;      ///< whole requests that wait for a worker
inline constexpr std::size_t passed_over = 32u
                                           << 20; ///< of what a refused request still sends [bytes]
inline constexpr std::chrono::seconds head_time{5};    ///< from the connection to the whole head
inline constexpr std::chrono::seconds body_time{30};   ///< from the head to the whole body
inline constexpr std::chrono::seconds answer_time{60}; ///< to send an answer
inline constexpr std::chrono::seconds passing_time{
    2};                                         ///< in which a refused request is passed over
inline constexpr std::size_t listeners = 8;     ///< pages that follow the progress
inline constexpr std::size_t queued_jobs = 64;  ///< jobs that wait or run
inline constexpr std::size_t kept_jobs = 500;   ///< of which the list tells
inline constexpr std::size_t found_jobs = 100;  ///< records that came with a folder and are shown
inline constexpr std::size_t record = 8u << 20; ///< of a job [bytes]
inline constexpr std::size_t found_record = 64u << 10; ///< of a job that came with a folder [bytes]
inline constexpr std::size_t checks_at_once = 4;
inline constexpr std::size_t listed_folders = 5000; ///< folders that are looked into for results
inline constexpr int listed_depth = 4;
inline constexpr std::size_t table_bytes = 256u << 20; ///< of a CSV file that is shown
inline constexpr std::size_t table_line = 1u << 20;    ///< of a row of it [bytes]
inline constexpr std::size_t table_columns = 20'000;
inline constexpr std::size_t table_cells = 16'000'000;
inline constexpr std::size_t table_words = 2'000'000;  ///< cells of columns that are not numbers
inline constexpr std::size_t table_text = 32u << 20;   ///< of those cells [bytes]
inline constexpr std::size_t frame_values = 64u << 20; ///< of a field at one instant
inline constexpr std::size_t child_output = 4u << 20;  ///< of a check [bytes]
inline constexpr std::size_t log_tail = 64u << 10;     ///< of a job's messages that is read [bytes]
inline constexpr std::size_t check_memory = 4ull << 30; ///< address space of a check [bytes]
inline constexpr std::chrono::seconds check_time{20};
inline constexpr std::chrono::seconds compare_time{60};
inline constexpr std::chrono::milliseconds poll{150}; ///< between two looks at the jobs

} // namespace ionskin::apps::studio::limits
