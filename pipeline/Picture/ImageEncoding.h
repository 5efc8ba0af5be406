// The meaning of an image's numbers, which every comparison of pictures needs.
#pragma once

namespace Drydock
{

enum class EImageEncoding
{
	Display, // sRGB-encoded, 0..1
	Linear,  // scene light, 0 and up
};

} // namespace Drydock
