// Implements OpenEXR's streams: one to read, and a file whose every write is checked.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <iosfwd>
#include <memory>
#include <string>

namespace Drydock
{

/** The stream, under a name for OpenEXR's messages. */
std::unique_ptr<Imf::IStream> MakeExrStream(const std::string& Name, std::unique_ptr<std::istream> Stream);

/** Collects what OpenEXR writes: it goes back to fill in the table of lines. */
class FExrOutput final : public Imf::OStream
{
public:
	FExrOutput()
		: OStream("memory")
	{
	}

	void write(const char Data[], int Count) override;
	uint64_t tellp() override { return At; }
	void seekp(uint64_t Position) override { At = Position; }

	const std::string& GetBytes() const { return Bytes; }

private:
	std::string Bytes;
	uint64_t At = 0;
};

/** Threads that OpenEXR packs and unpacks with, as many as passes have; 0: the calling one. */
int CountExrThreads();

} // namespace Drydock
