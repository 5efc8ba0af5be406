// Streams for OpenEXR over those of the standard library.
#include "Picture/ExrStreams.h"

#include "TileExecutor.h"

#include <OpenEXR/ImfThreading.h>

#include <cstring>
#include <istream>
#include <mutex>
#include <stdexcept>

namespace Drydock
{

namespace
{

class FExrInput final : public Imf::IStream
{
public:
	FExrInput(const std::string& Name, std::unique_ptr<std::istream> InStream)
		: IStream(Name.c_str())
		, Stream(std::move(InStream))
	{
	}

	bool read(char To[], int Count) override
	{
		if (!Stream->read(To, Count))
		{
			throw std::runtime_error("the file ends early");
		}
		return Stream->peek() != std::istream::traits_type::eof();
	}

	uint64_t tellg() override { return static_cast<uint64_t>(std::streamoff(Stream->tellg())); }
	void seekg(uint64_t Position) override
	{
		Stream->clear();
		Stream->seekg(static_cast<std::streamoff>(Position));
	}
	void clear() override { Stream->clear(); }

private:
	std::unique_ptr<std::istream> Stream;
};

} // namespace

std::unique_ptr<Imf::IStream> MakeExrStream(const std::string& Name, std::unique_ptr<std::istream> Stream)
{
	return std::make_unique<FExrInput>(Name, std::move(Stream));
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
