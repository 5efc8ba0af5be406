// SHA-256 gives the digests of FIPS 180-4's examples and of NIST's long message.
#include <gtest/gtest.h>

#include "ContentHash.h"

using Drydock::FContentHash;
using Drydock::HashBytes;

TEST(ContentHash, IsSha256)
{
	EXPECT_EQ("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855", HashBytes(""));
	EXPECT_EQ("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", HashBytes("abc"));
	EXPECT_EQ("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1",
		HashBytes("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"));
	EXPECT_EQ("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0", HashBytes(std::string(1000000, 'a')));
}

TEST(ContentHash, KeepsPiecesApart)
{
	FContentHash A;
	A.Add("ab");
	A.Add("c");
	FContentHash B;
	B.Add("a");
	B.Add("bc");
	EXPECT_NE(A.Finish(), B.Finish());
}
