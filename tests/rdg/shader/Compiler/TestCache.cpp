// The tests of this room compile into a cache of their own, so that they never see what an older build left behind.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace
{

class FOwnCache : public testing::Environment
{
	void SetUp() override
	{
		std::string Pattern = (std::filesystem::temp_directory_path() / "drydock-test-XXXXXX").string();
		ASSERT_TRUE(mkdtemp(Pattern.data()));
		Folder = Pattern;
		setenv("DRYDOCK_CACHE_DIR", Folder.c_str(), 1);
	}
	void TearDown() override
	{
		std::error_code Error;
		std::filesystem::remove_all(Folder, Error);
	}

	std::string Folder;
};

const testing::Environment* const OwnCache = testing::AddGlobalTestEnvironment(new FOwnCache);

} // namespace
