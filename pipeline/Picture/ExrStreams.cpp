// Streams over memory and files for OpenEXR.
#include "Picture/ExrStreams.h"

#include "TileExecutor.h"

#include <OpenEXR/ImfThreading.h>

#include <cstring>
#include <fstream>
#include <mutex>
#include <stdexcept>

namespace Drydock
{

namespace
{

class FMemoryInput final : public Imf::IStream
{
public:
	explicit FMemoryInput(const std::string& InBytes)
		: IStream("memory")
		, Bytes(InBytes)
	{
	}

	bool read(char To[], int Count) override
	{
		if (Count < 0 || At > Bytes.size() || static_cast<size_t>(Count) > Bytes.size() - At)
		{
			throw std::runtime_error("the file ends early");
		}
		std::memcpy(To, Bytes.data() + At, static_cast<size_t>(Count));
		At += static_cast<uint64_t>(Count);
		return At < Bytes.size();
	}

	uint64_t tellg() override { return At; }
	void seekg(uint64_t Position) override { At = Position; }

private:
	const std::string& Bytes;
	uint64_t At = 0;
};

class FFileInput final : public Imf::IStream
{
public:
	explicit FFileInput(const std::string& Path)
		: IStream(Path.c_str())
		, File(Path, std::ios::binary)
	{
		if (!File)
		{
			throw std::runtime_error("the file cannot be opened");
		}
	}

	bool read(char To[], int Count) override
	{
		if (!File.read(To, Count))
		{
			throw std::runtime_error("the file ends early");
		}
		return File.peek() != std::ifstream::traits_type::eof();
	}

	uint64_t tellg() override { return static_cast<uint64_t>(std::streamoff(File.tellg())); }

	void seekg(uint64_t Position) override
	{
		File.clear();
		File.seekg(static_cast<std::streamoff>(Position));
	}

	void clear() override { File.clear(); }

private:
	std::ifstream File;
};

} // namespace

std::unique_ptr<Imf::IStream> OpenExrStream(const std::string& Path, FImageBytesPointer Bytes)
{
	return Bytes != nullptr ? std::unique_ptr<Imf::IStream>(std::make_unique<FMemoryInput>(*Bytes))
							: std::make_unique<FFileInput>(Path);
}

void FExrOutput::write(const char Data[], int Count)
{
	const size_t End = At + static_cast<size_t>(Count);
	if (End > Bytes.size())
	{
		Bytes.resize(End);
	}
	std::memcpy(Bytes.data() + At, Data, static_cast<size_t>(Count));
	At = End;
}

int CountExrThreads()
{
	static std::mutex Mutex; // files are written side by side
	const std::lock_guard Lock(Mutex);
	const int NumThreads = GetNumThreads() > 1 ? GetNumThreads() : 0;
	if (Imf::globalThreadCount() != NumThreads)
	{
		Imf::setGlobalThreadCount(NumThreads);
	}
	return NumThreads;
}

} // namespace Drydock
