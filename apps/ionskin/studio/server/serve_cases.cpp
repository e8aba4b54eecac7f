// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/set_edit.hpp"
#include "ionskin/case/text/case_text.hpp"
#include "studio/data/case_check.hpp"
#include "studio/data/gallery.hpp"
#include "studio/server/server.hpp"
#include "verbs/keys.hpp"

namespace ionskin::apps::studio {

/// Adds the calls on cases: keys, checks, edits, the gallery.
void Server::serve_case_calls() {
  get("/api/keys",
      [](const Request&, Response& response) { send(response, keys_json(), json_type); });
  post("/api/case/check", [this](const Request& request, Response& response) {
    const Json verdict = check_case(workspace_, text_of(parse_object(request.body), "text"));
    send_json(response, verdict);
  });
  post("/api/case/set", [](const Request& request, Response& response) {
    const Json body = parse_object(request.body);
    CaseText text("the case", text_of(body, "text"));
    apply_set_edit(text, text_of(body, "key") + "=" + text_of(body, "value"));
    send_json(response, {{"text", text.text()}});
  });
  get("/api/gallery", [](const Request&, Response& response) { send_json(response, gallery()); });
  post("/api/gallery/open", [this](const Request& request, Response& response) {
    prepare(workspace_, text_of(parse_object(request.body), "id"));
    send_json(response, Json::object());
  });
}

} // namespace ionskin::apps::studio
