#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/topography/zip_archive.h>

#include <minizip/unzip.h>
#include <minizip/zip.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace asperity
{
  namespace
  {
    bool
    ends_with(const std::string &text, const std::string &tail)
    {
      return text.size() >= tail.size() &&
             text.compare(text.size() - tail.size(), tail.size(), tail) == 0;
    }
  } // namespace

  ZipArchive::ZipArchive(const FileContent &file, const std::string &format)
    : file(file)
    , format(format)
  {
    const std::string reason =
      "is cut off or damaged: the table of contents of the ZIP archive was "
      "not found";
    // minizip opens an archive that lacks the last bytes of its end record.
    const std::string &bytes = file.bytes();
    const auto         end   = bytes.rfind("PK\x05\x06");
    if (end == std::string::npos || bytes.size() - end < 22 ||
        bytes.size() - end - 22u < file.number<std::uint16_t>(end + 20))
      file.fail(format, reason);
    open_stream();
    if (handle == nullptr)
      file.fail(format, reason);
    // A broken table of contents may run in circles.
    constexpr unsigned int max_entries = 10000;
    for (int status = unzGoToFirstFile(handle);
         status == UNZ_OK && names.size() < max_entries;
         status = unzGoToNextFile(handle))
      {
        char            name[1024] = {};
        unz_file_info64 info;
        if (unzGetCurrentFileInfo64(
              handle, &info, name, sizeof(name) - 1, nullptr, 0, nullptr, 0) !=
            UNZ_OK)
          break;
        names.emplace_back(name);
      }
  }

  void
  ZipArchive::open_stream()
  {
    stream.bytes           = &file.bytes();
    zlib_filefunc64_def io = {};
    io.opaque              = &stream;
    io.zopen64_file        = [](voidpf opaque, const void *, int) {
      static_cast<Stream *>(opaque)->position = 0;
      return opaque;
    };
    io.zread_file = [](voidpf, voidpf handle, void *buffer, uLong size) {
      Stream     &s    = *static_cast<Stream *>(handle);
      const uLong left = s.bytes->size() - s.position;
      const uLong n    = std::min(size, left);
      std::memcpy(buffer, s.bytes->data() + s.position, n);
      s.position += n;
      return n;
    };
    io.zwrite_file = [](voidpf, voidpf, const void *, uLong) {
      return uLong(0);
    };
    io.ztell64_file = [](voidpf, voidpf handle) {
      return ZPOS64_T(static_cast<Stream *>(handle)->position);
    };
    io.zseek64_file = [](voidpf, voidpf handle, ZPOS64_T offset, int origin) {
      Stream        &s     = *static_cast<Stream *>(handle);
      const ZPOS64_T start = origin == ZLIB_FILEFUNC_SEEK_END ?
                               s.bytes->size() :
                             origin == ZLIB_FILEFUNC_SEEK_CUR ? s.position :
                                                                0;
      if (offset > s.bytes->size() - start)
        return -1l;
      s.position = start + offset;
      return 0l;
    };
    io.zclose_file = [](voidpf, voidpf) { return 0; };
    io.zerror_file = [](voidpf, voidpf) { return 0; };
    handle         = unzOpen2_64(nullptr, &io);
  }

  ZipArchive::~ZipArchive()
  {
    if (handle != nullptr)
      unzClose(handle);
  }

  std::string
  ZipArchive::find(const std::string &tail) const
  {
    std::string best;
    for (const auto &name : names)
      if (ends_with(name, tail) &&
          (name.size() == tail.size() ||
           name[name.size() - tail.size() - 1] == '/') &&
          name.compare(0, 9, "__MACOSX/") != 0 &&
          (best.empty() || name.size() < best.size()))
        best = name;
    return best;
  }

  std::size_t
  ZipArchive::stated_size(const std::string &entry) const
  {
    unz_file_info64 info = {};
    if (unzLocateFile(handle, entry.c_str(), 1) != UNZ_OK ||
        unzGetCurrentFileInfo64(
          handle, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
      file.fail(format, "holds no readable " + quoted_name(entry));
    check_unpacked_size(file, format, info.uncompressed_size);
    return info.uncompressed_size;
  }

  std::string
  ZipArchive::read(const std::string &entry, const std::size_t max_size) const
  {
    if (stated_size(entry) > max_size)
      file.fail(format,
                "holds " + std::to_string(stated_size(entry)) +
                  " bytes, more than the expected " + std::to_string(max_size) +
                  ", in " + quoted_name(entry));
    if (unzOpenCurrentFile(handle) != UNZ_OK)
      file.fail(format, "holds no readable " + quoted_name(entry));

    // In blocks and against the limit, since the stated size may be wrong.
    std::string bytes;
    std::string block(1 << 18, '\0');
    int         n = 0;
    while ((n = unzReadCurrentFile(handle, block.data(), block.size())) > 0)
      {
        bytes.append(block, 0, n);
        if (bytes.size() > max_size)
          {
            unzCloseCurrentFile(handle);
            file.fail(format,
                      "holds more than the expected " +
                        std::to_string(max_size) + " bytes in " +
                        quoted_name(entry));
          }
      }
    const int closed = unzCloseCurrentFile(handle);
    if (n < 0 || closed != UNZ_OK)
      file.fail(format,
                "is damaged: the checksum or the compressed data of " +
                  quoted_name(entry) + " is wrong");
    return bytes;
  }

  void
  write_zip(const std::string                                      &file,
            const std::vector<std::pair<std::string, std::string>> &entries)
  {
    errno                 = 0;
    const zipFile archive = zipOpen64(file.c_str(), APPEND_STATUS_CREATE);
    bool          good    = archive != nullptr;
    for (const auto &[name, bytes] : entries)
      {
        // The date 1 January 1980 makes equal content give equal files.
        zip_fileinfo info     = {};
        info.tmz_date.tm_mday = 1;
        info.tmz_date.tm_year = 1980;
        good                  = good && zipOpenNewFileInZip64(archive,
                                             name.c_str(),
                                             &info,
                                             nullptr,
                                             0,
                                             nullptr,
                                             0,
                                             nullptr,
                                             Z_DEFLATED,
                                             Z_BEST_COMPRESSION,
                                             0) == ZIP_OK;
        // minizip counts in unsigned int, so large maps go in pieces.
        for (std::size_t i = 0; good && i < bytes.size(); i += 1 << 28)
          good =
            zipWriteInFileInZip(archive,
                                bytes.data() + i,
                                static_cast<unsigned int>(std::min<std::size_t>(
                                  bytes.size() - i, 1 << 28))) == ZIP_OK;
        good = good && zipCloseFileInZip(archive) == ZIP_OK;
      }
    if (archive != nullptr)
      good = zipClose(archive, nullptr) == ZIP_OK && good;
    if (!good)
      throw ComputationError("The file " + file + " could not be written: " +
                             reason_of_failure(errno) + ".");
  }
} // namespace asperity
