// Data that blendables push into a view's settings, and that extensions find there by its type.
#include <gtest/gtest.h>

#include "PostProcessSettings.h"

namespace
{

struct FSharpenNode
{
	static FName GetFName() { return TEXT("FSharpenNode"); }
	float Strength = 0.0f;
};

struct FInterlaceNode
{
	static FName GetFName() { return TEXT("FInterlaceNode"); }
};

TEST(BlendableManager, IteratesOverOneTypeInOrder)
{
	FFinalPostProcessSettings Settings;
	Settings.BlendableManager.PushBlendableData(0.25f, FSharpenNode{2.0f});
	Settings.BlendableManager.PushBlendableData(1.0f, FInterlaceNode());
	Settings.BlendableManager.PushBlendableData(0.5f, FSharpenNode{3.0f})->Strength += 1.0f;
	const FFinalPostProcessSettings Copy = Settings;

	std::vector<std::pair<float, float>> Found;
	FBlendableEntry* Entry = nullptr;
	while (const FSharpenNode* const Node = Copy.BlendableManager.IterateBlendables<FSharpenNode>(Entry))
	{
		Found.emplace_back(Entry->Weight, Node->Strength);
	}
	EXPECT_EQ((std::vector<std::pair<float, float>>{{0.25f, 2.0f}, {0.5f, 4.0f}}), Found);
	EXPECT_EQ(nullptr, Entry);
	EXPECT_EQ(4.0f, Copy.BlendableManager.GetSingleFinalData<FSharpenNode>()->Strength);
}

TEST(BlendableManager, HasNothingOfATypeThatNobodyPushed)
{
	const FFinalPostProcessSettings Settings;
	FBlendableEntry* Entry = nullptr;
	EXPECT_EQ(nullptr, Settings.BlendableManager.IterateBlendables<FSharpenNode>(Entry));
	EXPECT_EQ(nullptr, Settings.BlendableManager.GetSingleFinalData<FInterlaceNode>());
}

} // namespace
