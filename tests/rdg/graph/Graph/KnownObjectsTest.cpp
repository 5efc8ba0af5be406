// A graph knows its objects by address and kind, however many there are.
#include <gtest/gtest.h>

#include "RenderGraphKnownObjects.h"

#include <map>
#include <random>

using namespace Drydock;

TEST(KnownObjects, NothingIsKnownAtFirst)
{
	const int Object = 0;
	EXPECT_FALSE(FRDGKnownObjects().Has(&Object, ERDGObject::Texture));
	EXPECT_FALSE(FRDGKnownObjects().Has(nullptr, ERDGObject::Texture));
}

TEST(KnownObjects, AnObjectIsKnownAsWhatItIs)
{
	const int Object = 0;
	FRDGKnownObjects Known;
	Known.Add(&Object, ERDGObject::Buffer);
	EXPECT_TRUE(Known.Has(&Object, ERDGObject::Texture | ERDGObject::Buffer));
	EXPECT_FALSE(Known.Has(&Object, ERDGObject::Texture));
}

TEST(KnownObjects, RandomAddressesAreThoseOfAMap)
{
	std::mt19937_64 Random(18);
	FRDGKnownObjects Known;
	std::map<const void*, ERDGObject> Expected;
	const auto Draw = [&Random]
	{
		return reinterpret_cast<const void*>(uintptr_t(16 * (1 + Random() % 40'000))); // near each other, as in blocks
	};
	for (int Step = 0; Step < 20'000; ++Step)
	{
		const void* const Object = Draw();
		const ERDGObject Kind = Random() % 2 ? ERDGObject::Texture : ERDGObject::Pass;
		if (Expected.emplace(Object, Kind).second)
		{
			Known.Add(Object, Kind);
		}
		const void* const Other = Draw();
		const auto Found = Expected.find(Other);
		ASSERT_EQ(
			Found != Expected.end() && Found->second == ERDGObject::Texture, Known.Has(Other, ERDGObject::Texture));
	}
}
