// Hand-written kernels and the text that they stand in for. All tests of this program hold kernels against their
// shaders whatever the text is; after they have passed, this file prints the fingerprint of a text that is new.
#include "NativeKernels.h"
#include "ShaderCompilation.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

using namespace Drydock;

namespace
{

class FKernelsForAnyText : public testing::Environment
{
public:
	void SetUp() override { AnyText = std::make_unique<FScopedNativeKernelsForAnyText>(); }

	void TearDown() override
	{
		const bool bKernelsPass = CountOtherFailures() == 0;
		for (const FNativeKernel& Kernel : AnyText->GetStoodIn())
		{
			if (!bKernelsPass)
			{
				break;
			}
			ADD_FAILURE()
				<< "The text of " << Kernel.Type->GetName() << " (" << Kernel.Type->GetShaderFilename()
				<< ", or what it includes) is new. If this was all of test_passes, its kernel agrees with it: "
				   "its REGISTER_NATIVE_KERNEL takes \""
				<< Kernel.Fingerprint << "\".";
		}
		AnyText.reset();
	}

private:
	/** Tests that failed, without those of this file. */
	static int CountOtherFailures()
	{
		const testing::UnitTest& All = *testing::UnitTest::GetInstance();
		int Count = 0;
		for (int i = 0; i < All.total_test_suite_count(); ++i)
		{
			const testing::TestSuite& Suite = *All.GetTestSuite(i);
			Count += std::string(Suite.name()) == "NativeText" ? 0 : Suite.failed_test_count();
		}
		return Count;
	}

	std::unique_ptr<FScopedNativeKernelsForAnyText> AnyText;
};

[[maybe_unused]] testing::Environment* const GEnvironment =
	testing::AddGlobalTestEnvironment(new FKernelsForAnyText); // gtest deletes it

} // namespace

TEST(NativeText, EveryPermutationOfAKernelsClassHasTheTextThatTheKernelKnows)
{
	ASSERT_EQ(18u, GetNativeKernels().size()) << "a kernel came or went";
	for (const FNativeKernel& Kernel : GetNativeKernels())
	{
		std::set<std::string> Fingerprints;
		for (int32 Id = 0; Id < Kernel.Type->GetPermutationCount() && Id < 48; ++Id)
		{
			if (Kernel.Type->ShouldCompilePermutation(Id))
			{
				Fingerprints.insert(GetShaderFingerprint(FShaderRef(Kernel.Type->FindOrCreateShader(Id))));
			}
		}
		EXPECT_EQ(1u, Fingerprints.size()) << Kernel.Type->GetName() << ": permutations include different files";
		EXPECT_TRUE(Fingerprints.contains(Kernel.Fingerprint))
			<< Kernel.Type->GetName() << ": the text is new; run all of test_passes, which says what to do";
	}
}
