// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <libwebsockets.h>

#include <algorithm>
#include <array>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/display/scene.hpp>
#include <hexagait/viewer/server/page_files.hpp>
#include <hexagait/viewer/server/server.hpp>
#include <hexagait/viewer/steering/command.hpp>
#include <map>
#include <vector>

namespace hexagait::viewer {
namespace {

constexpr std::size_t kChunk = 16384;       // of a file [bytes]
constexpr std::size_t kMostTransfers = 64;  // of files at once
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' "
    "data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string header(lws* socket, lws_token_indexes which) {
  std::array<char, 512> text{};
  const int length = lws_hdr_copy(socket, text.data(), static_cast<int>(text.size()), which);
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : std::string();
}

std::string token_of(lws* socket) {
  std::array<char, 128> text{};
  const char* const value = lws_get_urlarg_by_name(socket, "token=", text.data(), text.size());
  return value != nullptr ? value : "";
}

}  // namespace

class Server::Impl {
 public:
  Impl(Access access, Host& host) : access_(std::move(access)), host_(host) {
    lws_set_log_level(0, nullptr);
    protocols_[0] = {"http", call, 0, kMaxMessage + 1, 0, this, 0};
    keep_alive_.secs_since_valid_ping = 5;
    keep_alive_.secs_since_valid_hangup = 12;

    lws_context_creation_info info{};
    info.port = CONTEXT_PORT_NO_LISTEN;
    info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
    context_.reset(lws_create_context(&info));
    if (!context_) throw InvalidInput("the web server can't start: no memory, or no sockets");
    timer_.context = context_.get();
    listen();
    host_.on_news([this] { lws_cancel_service(context_.get()); });
  }

  ~Impl() { host_.on_news(nullptr); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void run(const std::atomic<bool>& stop) {
    look_again(&timer_.list);
    while (!stop && lws_service(context_.get(), 0) >= 0) {
    }
    lws_sul_cancel(&timer_.list);
  }

  [[nodiscard]] const Access& access() const { return access_; }

 private:
  struct Client {
    ClientId id = 0;
    Host::Seen seen;
    std::string incoming;
    bool too_long = false;
    std::vector<std::string> answers;  // of bounded number: see answer()
  };
  struct Transfer {
    std::string_view rest;
  };
  struct Timer {
    lws_sorted_usec_list_t list{};
    lws_context* context = nullptr;
  };
  struct Destroy {
    void operator()(lws_context* context) const { lws_context_destroy(context); }
  };

  void listen() {
    lws_context_creation_info info{};
    info.port = access_.port;
    info.iface = access_.bind.c_str();
    info.protocols = protocols_.data();
    info.options = LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND;
    if (access_.bind.find(':') == std::string::npos) info.options |= LWS_SERVER_OPTION_DISABLE_IPV6;
    info.retry_and_idle_policy = &keep_alive_;
    lws_vhost* const host = lws_create_vhost(context_.get(), &info);
    if (host == nullptr)
      throw InvalidInput(fmt::format(
          "can't listen on {} port {}: another program does, or this machine has no such address; "
          "--port N takes another port (0: any that is free), --bind A another address",
          access_.bind, access_.port));
    access_.port = lws_get_vhost_listen_port(host);
  }

  // Ends a wait of the service now and then, so that run() sees that it is to stop.
  static void look_again(lws_sorted_usec_list_t* list) {
    const Timer& timer = *reinterpret_cast<Timer*>(list);
    lws_sul_schedule(timer.context, 0, list, look_again, 50 * LWS_US_PER_MS);
  }

  static int call(lws* socket, lws_callback_reasons reason, void* /*user*/, void* in,
                  std::size_t size) {
    const lws_protocols* const protocol = lws_get_protocol(socket);
    if (protocol == nullptr || protocol->user == nullptr) return 0;
    auto& server = *static_cast<Impl*>(protocol->user);
    const std::string_view content(static_cast<const char*>(in), in != nullptr ? size : 0);
    switch (reason) {
      case LWS_CALLBACK_HTTP:
        return server.request(socket, content);
      case LWS_CALLBACK_HTTP_WRITEABLE:
        return server.send_file(socket);
      case LWS_CALLBACK_CLOSED_HTTP:
        server.transfers_.erase(socket);
        return 0;
      case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return server.may_enter(socket) ? 0 : 1;
      case LWS_CALLBACK_ESTABLISHED:
        server.enter(socket);
        return 0;
      case LWS_CALLBACK_RECEIVE:
        server.receive(socket, content);
        return 0;
      case LWS_CALLBACK_SERVER_WRITEABLE:
        return server.send(socket);
      case LWS_CALLBACK_CLOSED:
        server.leave(socket);
        return 0;
      case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
        for (const auto& [client, ignored] : server.clients_) lws_callback_on_writable(client);
        return 0;
      default:
        return 0;
    }
  }

  int request(lws* socket, std::string_view path) {
    if (!is_our_host(access_, header(socket, WSI_TOKEN_HOST)) ||
        lws_hdr_total_length(socket, WSI_TOKEN_GET_URI) <= 0)
      return refuse(socket, HTTP_STATUS_FORBIDDEN);
    if (path == "/") path = "/index.html";
    const auto files = page_files();
    const auto file = std::ranges::find(files, path, &PageFile::path);
    if (file == files.end()) return refuse(socket, HTTP_STATUS_NOT_FOUND);
    if (transfers_.size() >= kMostTransfers) return refuse(socket, HTTP_STATUS_SERVICE_UNAVAILABLE);
    if (!send_header(socket, *file)) return 1;
    transfers_[socket] = {file->content};
    lws_callback_on_writable(socket);
    return 0;
  }

  static int refuse(lws* socket, unsigned status) {
    lws_return_http_status(socket, status, nullptr);
    return lws_http_transaction_completed(socket);
  }

  static bool send_header(lws* socket, const PageFile& file) {
    std::array<unsigned char, LWS_PRE + 2048> buffer{};
    unsigned char* const begin = buffer.data() + LWS_PRE;
    unsigned char* at = begin;
    unsigned char* const end = buffer.data() + buffer.size() - 1;
    const std::string type(file.type);
    if (lws_add_http_common_headers(socket, HTTP_STATUS_OK, type.c_str(), file.content.size(), &at,
                                    end) != 0)
      return false;
    constexpr std::array<std::pair<const char*, const char*>, 6> kHeaders = {{
        {"content-encoding:", "gzip"},
        {"content-security-policy:", kPolicy},
        {"x-content-type-options:", "nosniff"},
        {"referrer-policy:", "no-referrer"},
        {"cross-origin-resource-policy:", "same-origin"},
        {"cache-control:", "no-cache"},
    }};
    for (const auto& [name, value] : kHeaders)
      if (lws_add_http_header_by_name(socket, reinterpret_cast<const unsigned char*>(name),
                                      reinterpret_cast<const unsigned char*>(value),
                                      static_cast<int>(std::string_view(value).size()), &at,
                                      end) != 0)
        return false;
    return lws_finalize_write_http_header(socket, begin, &at, end) == 0;
  }

  int send_file(lws* socket) {
    const auto found = transfers_.find(socket);
    if (found == transfers_.end()) return 0;
    std::string_view& rest = found->second.rest;
    const std::string_view chunk = rest.substr(0, kChunk);
    rest.remove_prefix(chunk.size());
    const auto how = rest.empty() ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP;
    if (!write(socket, chunk, how)) return 1;
    if (!rest.empty()) return lws_callback_on_writable(socket) < 0 ? 1 : 0;
    transfers_.erase(found);
    return lws_http_transaction_completed(socket);
  }

  bool write(lws* socket, std::string_view content, lws_write_protocol how) {
    out_.assign(LWS_PRE, '\0');
    out_ += content;
    auto* const bytes = reinterpret_cast<unsigned char*>(out_.data()) + LWS_PRE;
    return lws_write(socket, bytes, content.size(), how) >= static_cast<int>(content.size());
  }

  bool may_enter(lws* socket) const {
    const std::string host = header(socket, WSI_TOKEN_HOST);
    return header(socket, WSI_TOKEN_GET_URI) == "/ws" && is_our_host(access_, host) &&
           is_our_origin(access_, header(socket, WSI_TOKEN_ORIGIN), host) &&
           is_token(access_, token_of(socket)) && clients_.size() < kMostClients;
  }

  void enter(lws* socket) {
    Client& client = clients_[socket];
    client.id = host_.enter();
    client.answers = {hello_json(client.id)};
    lws_callback_on_writable(socket);
  }

  void leave(lws* socket) {
    const auto found = clients_.find(socket);
    if (found == clients_.end()) return;
    host_.leave(found->second.id);
    clients_.erase(found);
  }

  // Of a message that is too long only so much is kept as shows that it is.
  void receive(lws* socket, std::string_view part) {
    const auto found = clients_.find(socket);
    if (found == clients_.end()) return;
    Client& client = found->second;
    const std::size_t room = kMaxActionMessage + 1 - client.incoming.size();
    client.incoming.append(part.substr(0, room));
    if (lws_remaining_packet_payload(socket) != 0 || lws_is_final_fragment(socket) == 0) return;
    answer(socket, client, host_.receive(client.id, client.incoming));
    client.incoming.clear();
  }

  // A client that asks for nonsense and does not read the answers gets the newest ones only.
  static void answer(lws* socket, Client& client, std::string text) {
    constexpr std::size_t kMostAnswers = 4;
    if (text.empty()) return;
    if (client.answers.size() >= kMostAnswers) client.answers.erase(client.answers.begin() + 1);
    client.answers.push_back(std::move(text));
    lws_callback_on_writable(socket);
  }

  // One message at a time: what is newest when the client has taken the one before.
  int send(lws* socket) {
    const auto found = clients_.find(socket);
    if (found == clients_.end()) return 0;
    Client& client = found->second;
    if (!client.answers.empty()) {
      const std::string text = std::move(client.answers.front());
      client.answers.erase(client.answers.begin());
      lws_callback_on_writable(socket);
      return write(socket, text, LWS_WRITE_TEXT) ? 0 : -1;
    }
    Host::Letter letter;
    if (!host_.newer_than(client.seen, letter)) return 0;
    const bool is_frame = letter.kind == Host::Mail::frame;
    if (!is_frame) lws_callback_on_writable(socket);
    return write(socket, letter.content, is_frame ? LWS_WRITE_BINARY : LWS_WRITE_TEXT) ? 0 : -1;
  }

  Access access_;
  Host& host_;
  std::array<lws_protocols, 2> protocols_{};
  lws_retry_bo_t keep_alive_{};
  std::map<lws*, Client> clients_;
  std::map<lws*, Transfer> transfers_;
  std::string out_;
  Timer timer_;
  std::unique_ptr<lws_context, Destroy> context_;  // last: its callbacks use all of the above
};

Server::Server(Access access, Host& host)
    : impl_(std::make_unique<Impl>(std::move(access), host)) {}

Server::~Server() = default;

void Server::run(const std::atomic<bool>& stop) { impl_->run(stop); }

int Server::port() const { return impl_->access().port; }

std::string Server::url() const {
  const Access& access = impl_->access();
  const bool six = access.bind.find(':') != std::string::npos;
  const std::string host = six ? "[" + access.bind + "]" : access.bind;
  const std::string page = fmt::format("http://{}:{}/", host, access.port);
  return access.token.empty() ? page : page + "#token=" + access.token;
}

}  // namespace hexagait::viewer
