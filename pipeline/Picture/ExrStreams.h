// Implements OpenEXR's streams: a file or bytes in memory to read, and a file whose every write is checked.
#pragma once

#include "Picture/ImageReader.h"

#include <OpenEXR/ImfIO.h>

namespace Drydock
{

/** Bytes null: the file at Path. Throws std::exception where it cannot be opened. */
std::unique_ptr<Imf::IStream> OpenExrStream(const std::string& Path, FImageBytesPointer Bytes);

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
