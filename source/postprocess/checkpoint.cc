#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/postprocess/checkpoint.h>

#include <cstring>
#include <fstream>
#include <iterator>

namespace asperity
{
  namespace
  {
    struct Head
    {
      char          word[8]  = {'A', 'S', 'P', 'E', 'R', 'I', 'T', 'Y'};
      std::uint32_t version  = Checkpoint::format_version;
      std::uint32_t order    = 0x01020304;
      std::uint64_t length   = 0;
      std::uint64_t checksum = 0;
    };
    static_assert(sizeof(Head) == 32, "the head has no padding");

    /** FNV-1a, 64 bit: finds damage by accident, not by intent. */
    std::uint64_t
    checksum(const std::string &bytes)
    {
      std::uint64_t sum = 14695981039346656037ull;
      for (const char byte : bytes)
        {
          sum ^= static_cast<unsigned char>(byte);
          sum *= 1099511628211ull;
        }
      return sum;
    }

    void
    append(std::string &bytes, const void *data, const std::size_t size)
    {
      if (size > 0)
        bytes.append(static_cast<const char *>(data), size);
    }

    /** A count, then the items: a string or a vector of numbers. */
    template <typename Items>
    void
    append_items(std::string &bytes, const Items &items)
    {
      const std::uint64_t n = items.size();
      append(bytes, &n, sizeof(n));
      append(bytes, items.data(), n * sizeof(typename Items::value_type));
    }

    template <typename Entries>
    void
    append_entries(std::string &bytes, const Entries &entries)
    {
      const std::uint64_t n = entries.size();
      append(bytes, &n, sizeof(n));
      for (const auto &[name, items] : entries)
        {
          append_items(bytes, name);
          append_items(bytes, items);
        }
    }

    /** Reads what append_entries() wrote and never beyond the end. */
    class Reader
    {
    public:
      Reader(const std::string &bytes, const std::string &path)
        : bytes(bytes)
        , path(path)
      {}

      template <typename Entries>
      void
      read_entries(Entries &entries)
      {
        const std::uint64_t n = count(1);
        for (std::uint64_t i = 0; i < n; ++i)
          {
            std::string name;
            read_items(name);
            read_items(entries[name]);
          }
      }

      bool
      at_end() const
      {
        return position == bytes.size();
      }

    private:
      std::uint64_t
      count(const std::size_t item_size)
      {
        std::uint64_t n;
        take(&n, sizeof(n));
        if (n > (bytes.size() - position) / item_size)
          fail();
        return n;
      }

      template <typename Items>
      void
      read_items(Items &items)
      {
        using Item = typename Items::value_type;
        items.resize(count(sizeof(Item)));
        take(items.data(), items.size() * sizeof(Item));
      }

      void
      take(void *data, const std::size_t size)
      {
        if (size > bytes.size() - position)
          fail();
        if (size > 0)
          std::memcpy(data, bytes.data() + position, size);
        position += size;
      }

      [[noreturn]] void
      fail() const
      {
        throw InputError("The checkpoint " + path +
                         " is damaged: an entry reaches beyond its end.");
      }

      const std::string &bytes;
      const std::string &path;
      std::size_t        position = 0;
    };

    void
    check_head(const Head &head, const std::string &path)
    {
      if (std::memcmp(head.word, Head().word, sizeof(head.word)) != 0)
        throw InputError("The file " + path +
                         " is not a checkpoint: it does not begin with the "
                         "word ASPERITY.");
      if (head.order != Head().order)
        throw InputError("The checkpoint " + path +
                         " was written on a machine of another byte order.");
      if (head.version != Checkpoint::format_version)
        throw InputError("The checkpoint " + path + " has format version " +
                         std::to_string(head.version) +
                         ", but this program reads version " +
                         std::to_string(Checkpoint::format_version) + ".");
    }

    template <typename Entries>
    const typename Entries::mapped_type &
    find(const Entries     &entries,
         const std::string &name,
         const std::string &kind,
         const std::string &source)
    {
      const auto entry = entries.find(name);
      if (entry == entries.end())
        throw InputError(
          "The checkpoint " + (source.empty() ? "in memory" : source) +
          " holds no " + kind + " named '" + name + "', which is expected.");
      return entry->second;
    }
  } // namespace



  void
  Checkpoint::set(const std::string &name, const std::vector<double> &values)
  {
    double_entries[name] = values;
  }



  void
  Checkpoint::set(const std::string               &name,
                  const std::vector<std::int64_t> &values)
  {
    integer_entries[name] = values;
  }



  void
  Checkpoint::set(const std::string &name, const std::string &text)
  {
    text_entries[name] = text;
  }



  const std::vector<double> &
  Checkpoint::doubles(const std::string &name) const
  {
    return find(double_entries, name, "numbers", source);
  }



  const std::vector<std::int64_t> &
  Checkpoint::integers(const std::string &name) const
  {
    return find(integer_entries, name, "integers", source);
  }



  const std::string &
  Checkpoint::text(const std::string &name) const
  {
    return find(text_entries, name, "text", source);
  }



  const std::vector<double> &
  Checkpoint::doubles(const std::string &name, const std::size_t size) const
  {
    const std::vector<double> &values = doubles(name);
    if (values.size() != size)
      throw InputError(
        "The checkpoint " + (source.empty() ? "in memory" : source) +
        " holds " + std::to_string(values.size()) + " numbers named '" + name +
        "', but " + std::to_string(size) + " are expected.");
    return values;
  }



  std::string
  Checkpoint::pack() const
  {
    std::string bytes;
    append_entries(bytes, double_entries);
    append_entries(bytes, integer_entries);
    append_entries(bytes, text_entries);
    return bytes;
  }



  void
  Checkpoint::write(const std::string &path) const
  {
    const std::string bytes = pack();
    Head              head;
    head.length   = bytes.size();
    head.checksum = checksum(bytes);
    write_atomically(
      path,
      [&](std::ostream &out) {
        out.write(reinterpret_cast<const char *>(&head), sizeof(head));
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      },
      Durability::machine);
  }



  Checkpoint
  Checkpoint::read(const std::string &path)
  {
    std::ifstream in(path, std::ios::binary);
    if (!in)
      throw InputError("The checkpoint " + path + " could not be opened.");
    const std::string content{std::istreambuf_iterator<char>(in), {}};

    Head head;
    if (content.size() < sizeof(head))
      throw InputError("The file " + path +
                       " is not a checkpoint: it is shorter than the head of "
                       "one.");
    std::memcpy(&head, content.data(), sizeof(head));
    check_head(head, path);
    const std::string bytes = content.substr(sizeof(head));
    if (bytes.size() != head.length)
      throw InputError("The checkpoint " + path + " holds " +
                       std::to_string(bytes.size()) +
                       " bytes of entries, but " + std::to_string(head.length) +
                       " are expected: it was cut short or added to.");
    if (checksum(bytes) != head.checksum)
      throw InputError("The checkpoint " + path +
                       " is damaged: its checksum does not fit its content.");

    Checkpoint checkpoint;
    Reader     reader(bytes, path);
    reader.read_entries(checkpoint.double_entries);
    reader.read_entries(checkpoint.integer_entries);
    reader.read_entries(checkpoint.text_entries);
    if (!reader.at_end())
      throw InputError("The checkpoint " + path +
                       " is damaged: there is more in it than its entries.");
    checkpoint.source = path;
    return checkpoint;
  }



  bool
  Checkpoint::operator==(const Checkpoint &other) const
  {
    return pack() == other.pack();
  }
} // namespace asperity
