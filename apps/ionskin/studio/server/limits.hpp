// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>

namespace ionskin::apps::studio::limits {

// Upper bounds of everything that a page or a stranger could make large.

inline constexpr std::size_t head = 32u << 10;   ///< lines of a request before its body [bytes]
inline constexpr std::size_t headers = 100;      ///< number of headers of a request
inline constexpr std::size_t body = 4u << 20;    ///< body of a request [bytes]
inline constexpr std::size_t upload = 16u << 20; ///< uploaded CSV file with measured data [bytes]
inline constexpr std::size_t bodies = 64u << 20; ///< bodies of all requests at once [bytes]
inline constexpr std::size_t connections = 128;  ///< connections whose requests are read at once
inline constexpr std::size_t workers = 16;       ///< requests that are answered at once
inline constexpr std::size_t waiting = 256;      ///< whole requests that wait for a worker
/// Data that a refused request still sends, and that is discarded [bytes].
inline constexpr std::size_t passed_over = 32u << 20;
inline constexpr std::chrono::seconds head_time{5};  ///< time from the connection to the whole head
inline constexpr std::chrono::seconds body_time{30}; ///< time from the head to the whole body
inline constexpr std::chrono::seconds answer_time{60}; ///< time to send an answer
/// Time for which the data of a refused request is discarded.
inline constexpr std::chrono::seconds passing_time{2};
inline constexpr std::size_t listeners = 8;    ///< pages that follow the progress at once
inline constexpr std::size_t queued_jobs = 64; ///< jobs that wait or run
/// Recorded jobs; older ones are removed at the start.
inline constexpr std::size_t kept_jobs = 500;
/// Listed records of jobs that came with a workspace.
inline constexpr std::size_t found_jobs = 100;
inline constexpr std::size_t record = 8u << 20; ///< record of a job [bytes]
/// Record of a job that came with a workspace [bytes].
inline constexpr std::size_t found_record = 64u << 10;
inline constexpr std::size_t checks_at_once = 4;    ///< checks of cases that run at once
inline constexpr std::size_t listed_folders = 5000; ///< folders that are searched for results
/// Levels of folders, below the workspace, that are searched for results.
inline constexpr int listed_depth = 4;
inline constexpr std::size_t table_bytes = 256u << 20; ///< CSV file that is shown [bytes]
inline constexpr std::size_t table_line = 1u << 20;    ///< row of a CSV file that is shown [bytes]
inline constexpr std::size_t table_columns = 20'000;   ///< columns of a CSV file that is shown
inline constexpr std::size_t table_cells = 16'000'000; ///< cells of a CSV file that is shown
inline constexpr std::size_t table_words = 2'000'000;  ///< cells in columns that are not numbers
inline constexpr std::size_t table_text = 32u << 20;   ///< text in such cells [bytes]
inline constexpr std::size_t frame_values = 64u << 20; ///< values of a field at one instant
inline constexpr std::size_t child_output = 4u << 20;  ///< output of a check [bytes]
inline constexpr std::size_t log_tail = 64u << 10; ///< end of a job's messages that is read [bytes]
inline constexpr std::size_t check_memory = 4ull << 30; ///< address space of a check [bytes]
inline constexpr std::chrono::seconds check_time{20};   ///< time of a check
inline constexpr std::chrono::seconds compare_time{60}; ///< time of a comparison of two runs
inline constexpr std::chrono::milliseconds poll{150};   ///< interval between two looks at the jobs

} // namespace ionskin::apps::studio::limits
