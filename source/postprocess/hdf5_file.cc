#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/md5.h>
#include <asperity/base/text.h>
#include <asperity/postprocess/hdf5_file.h>

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

namespace asperity
{
  namespace fs = std::filesystem;

  namespace
  {
    /** A function of libhdf5 has failed; the caller knows of which file. */
    struct Failure
    {};

    /** An object of libhdf5 that is closed in every case. */
    class Handle
    {
    public:
      Handle(const hid_t id, herr_t (*close)(hid_t))
        : id(id)
        , close(close)
      {
        if (id < 0)
          throw Failure();
      }

      ~Handle()
      {
        close(id);
      }

      Handle(const Handle &) = delete;
      Handle &
      operator=(const Handle &) = delete;

      operator hid_t() const
      {
        return id;
      }

    private:
      const hid_t id;
      herr_t (*const close)(hid_t);
    };

    void
    require(const herr_t status)
    {
      if (status < 0)
        throw Failure();
    }

    constexpr std::size_t user_block_size = 512;

    /** libhdf5 prints nothing by itself; messages are those of this program. */
    void
    keep_silent()
    {
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }

    void
    write_table(const hid_t        file,
                const std::string &name,
                const Hdf5Table   &table)
    {
      const std::array<hsize_t, 2> size{{table.n_rows, table.n_columns}};
      const Handle space(H5Screate_simple(2, size.data(), nullptr), H5Sclose);
      const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
      constexpr hsize_t            most_numbers_of_chunk = 1 << 17;
      const std::array<hsize_t, 2> chunk{
        {std::clamp<hsize_t>(most_numbers_of_chunk /
                               std::max<hsize_t>(1, table.n_columns),
                             1,
                             std::max<hsize_t>(1, table.n_rows)),
         std::max<hsize_t>(1, table.n_columns)}};
      if (!table.values.empty()) // which alone has chunks
        {
          require(H5Pset_chunk(properties, 2, chunk.data()));
          require(H5Pset_shuffle(properties));
          require(H5Pset_deflate(properties, 1));
        }
      const Handle set(H5Dcreate2(file,
                                  name.c_str(),
                                  H5T_IEEE_F64LE,
                                  space,
                                  H5P_DEFAULT,
                                  properties,
                                  H5P_DEFAULT),
                       H5Dclose);
      if (!table.values.empty())
        require(H5Dwrite(set,
                         H5T_NATIVE_DOUBLE,
                         H5S_ALL,
                         H5S_ALL,
                         H5P_DEFAULT,
                         table.values.data()));
    }

    /** A text of one line after the other as a data set of its own, since an
     *  attribute has at most 64 kB. */
    void
    write_text(const hid_t        file,
               const std::string &name,
               const std::string &text)
    {
      const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
      require(H5Tset_size(type, std::max<std::size_t>(1, text.size())));
      require(H5Tset_strpad(type, H5T_STR_NULLPAD));
      const Handle      space(H5Screate(H5S_SCALAR), H5Sclose);
      const Handle      set(H5Dcreate2(file,
                                  name.c_str(),
                                  type,
                                  space,
                                  H5P_DEFAULT,
                                  H5P_DEFAULT,
                                  H5P_DEFAULT),
                       H5Dclose);
      const std::string padded = text.empty() ? std::string(1, '\0') : text;
      require(
        H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()));
    }

    /** The file as libhdf5 makes it, in memory; of its oldest format, since the
     *  head of newer ones has a checksum that H5Fget_file_image() breaks. */
    std::string
    image_of(const Hdf5Content &content)
    {
      const Handle          access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
      constexpr std::size_t growth = 1 << 20;
      require(H5Pset_fapl_core(access, growth, 0));
      const Handle file(H5Fcreate("fields", H5F_ACC_TRUNC, H5P_DEFAULT, access),
                        H5Fclose);
      for (const auto &[name, table] : content.tables)
        write_table(file, name, table);
      for (const auto &[name, text] : content.texts)
        write_text(file, name, text);
      require(H5Fflush(file, H5F_SCOPE_GLOBAL));
      const ssize_t size = H5Fget_file_image(file, nullptr, 0);
      if (size <= 0)
        throw Failure();
      std::string image(static_cast<std::size_t>(size), '\0');
      if (H5Fget_file_image(file, image.data(), image.size()) != size)
        throw Failure();
      return image;
    }

    /** What stands before HDF5's own part: a user block of the smallest size,
     *  which HDF5 leaves to the application. */
    std::string
    user_block(const std::string &image)
    {
      std::string block =
        "Asperity, HDF5 file; MD5 of all behind byte 512: " + md5(image) + "\n";
      block.resize(user_block_size, '\0');
      return block;
    }

    Hdf5Table
    read_table(const hid_t set)
    {
      const Handle           space(H5Dget_space(set), H5Sclose);
      std::array<hsize_t, 2> size{{0, 0}};
      if (H5Sget_simple_extent_ndims(space) != 2)
        throw Failure();
      require(H5Sget_simple_extent_dims(space, size.data(), nullptr));
      // A damaged size would ask for any amount of memory: no table has more
      // numbers than 2^32.
      if (size[1] > 0 && size[0] > (1ull << 32) / size[1])
        throw Failure();
      Hdf5Table table{size[0], size[1], std::vector<double>(size[0] * size[1])};
      if (!table.values.empty())
        require(H5Dread(set,
                        H5T_NATIVE_DOUBLE,
                        H5S_ALL,
                        H5S_ALL,
                        H5P_DEFAULT,
                        table.values.data()));
      return table;
    }

    herr_t
    add_name(const hid_t, const char *name, const H5L_info_t *, void *names)
    {
      static_cast<std::vector<std::string> *>(names)->emplace_back(name);
      return 0;
    }

    std::string
    read_text(const hid_t set, const hid_t type)
    {
      if (H5Tis_variable_str(type) != 0)
        throw Failure();
      std::string text(H5Tget_size(type), '\0');
      require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()));
      text.resize(std::min(text.find('\0'), text.size()));
      return text;
    }

    std::string
    read_bytes(const std::string &path)
    {
      std::ifstream      in(path, std::ios::binary);
      std::ostringstream bytes;
      bytes << in.rdbuf();
      if (!in)
        throw Failure();
      return bytes.str();
    }

    Hdf5Content
    read_all(const std::string &path)
    {
      std::string image = read_bytes(path);
      if (image.size() <= user_block_size)
        throw Failure();
      const std::string block = image.substr(0, user_block_size);
      image.erase(0, user_block_size);
      if (block != user_block(image))
        throw Failure();
      Hdf5Content  content;
      const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
      require(H5Pset_fapl_core(access, user_block_size, 0));
      require(H5Pset_file_image(access, image.data(), image.size()));
      const Handle file(H5Fopen("fields", H5F_ACC_RDONLY, access), H5Fclose);
      std::vector<std::string> names;
      require(H5Literate(
        file, H5_INDEX_NAME, H5_ITER_INC, nullptr, add_name, &names));
      for (const std::string &name : names)
        {
          const Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
          const Handle type(H5Dget_type(set), H5Tclose);
          if (H5Tget_class(type) == H5T_STRING)
            content.texts[name] = read_text(set, type);
          else
            content.tables[name] = read_table(set);
        }
      return content;
    }
  } // namespace



  void
  Hdf5Content::write(const std::string &path) const
  {
    keep_silent();
    std::string image;
    try
      {
        image = image_of(*this);
      }
    catch (const Failure &)
      {
        throw ComputationError("The file " + quoted_name(path) +
                               " could not be written: HDF5 has failed.");
      }
    write_atomically(path, [&](std::ostream &out) {
      out << user_block(image) << image;
    });
  }



  Hdf5Content
  Hdf5Content::read(const std::string &path, const std::string &expected)
  {
    keep_silent();
    if (!fs::is_regular_file(path))
      throw InputError("The file " + quoted_name(path) +
                       " could not be opened; " + expected + " are expected.");
    try
      {
        return read_all(path);
      }
    catch (const Failure &)
      {
        throw InputError("The file " + quoted_name(path) +
                         " is no HDF5 file of this program, not complete, or "
                         "damaged; " +
                         expected + " are expected.");
      }
  }



  const Hdf5Table &
  Hdf5Content::table(const std::string &name,
                     const std::size_t  n_columns,
                     const std::string &origin) const
  {
    const auto found = tables.find(name);
    if (found == tables.end())
      throw InputError("The file " + quoted_name(origin) + " has no table " +
                       quoted_name(name) + ".");
    if (found->second.n_columns != n_columns)
      throw InputError("The table " + quoted_name(name) + " of the file " +
                       quoted_name(origin) + " has " +
                       std::to_string(found->second.n_columns) +
                       " columns, where " + std::to_string(n_columns) +
                       " are expected.");
    return found->second;
  }



  const std::string &
  Hdf5Content::text(const std::string &name, const std::string &origin) const
  {
    const auto found = texts.find(name);
    if (found == texts.end())
      throw InputError("The file " + quoted_name(origin) + " does not say " +
                       quoted_name(name) + ".");
    return found->second;
  }
} // namespace asperity
