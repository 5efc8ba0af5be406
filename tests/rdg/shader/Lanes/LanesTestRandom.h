// Numbers by chance for tests of lanes: the same ones for a seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace Drydock::Tests
{

class FTestRandom
{
public:
	explicit FTestRandom(uint32_t Seed)
		: Engine(Seed)
	{
	}
	int32_t Int(int32_t Low, int32_t High) { return std::uniform_int_distribution<int32_t>(Low, High)(Engine); }
	float Float(double Low, double High) { return float(std::uniform_real_distribution<double>(Low, High)(Engine)); }
	template<typename T, size_t Count>
	T Pick(const T (&From)[Count])
	{
		return From[Int(0, int32_t(Count) - 1)];
	}

	std::mt19937 Engine;
};

} // namespace Drydock::Tests
