#include "text/xml.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "input_error_expectation.hpp"

namespace nearfield::host {
namespace {

TEST(Xml, ReadsElementsAttributesAndText) {
  const XmlDocument document = parse_xml(
      "\xef\xbb\xbf<?xml version='1.0' encoding=\"utf-8\"?>\n<!-- a -- comment --->\n"
      "<robot name=\"a&lt;&#233;&#x20AC;\tb\" xmlns:xacro='x>y'>one<link/>&amp;two<!-- c -->\n"
      "  <joint type = 'fixed' ></joint >\n</robot>\n<!-- end -->",
      "f");
  const XmlElement& root = document.root;
  EXPECT_EQ(root.name, "robot");
  EXPECT_EQ(root.position.line, 3U);
  EXPECT_EQ(root.position.column, 1U);
  ASSERT_NE(root.find_attribute("name"), nullptr);
  EXPECT_EQ(root.find_attribute("name")->value, "a<é€ b");
  EXPECT_EQ(root.find_attribute("xmlns:xacro")->value, "x>y");
  EXPECT_EQ(root.find_attribute("absent"), nullptr);
  EXPECT_EQ(root.text, "one&two\n  \n");
  ASSERT_EQ(root.children.size(), 2U);
  EXPECT_EQ(root.children[1].name, "joint");
  EXPECT_EQ(root.children[1].position.line, 4U);
  EXPECT_EQ(root.children[1].position.column, 3U);
  EXPECT_EQ(root.children[1].attributes[0].position.column, 10U);
}

TEST(Xml, DepthIsLimited) {
  std::string open;
  std::string close;
  for (int level = 0; level < 64; ++level) {
    open += "<a>";
    close += "</a>";
  }
  EXPECT_NO_THROW(parse_xml(open + close, "f"));
  try {
    parse_xml(open + "<a/>" + close, "file");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.message(), "nested too deeply");
    EXPECT_EQ(error.column(), 193U);
  }
}

TEST(Xml, AttributeCountIsLimited) {
  std::string text = "<a";
  for (std::size_t index = 0; index <= most_xml_attributes; ++index)
    text += " b" + std::to_string(index) + "=''";
  expect_input_error(parse_xml, {text + "/>", "file:1:1942: a: too many attributes; at most 256"});
}

TEST(Xml, RefusesWhatIsNotWellFormed) {
  const std::vector<Malformed> cases{
      {"", "file:1:1: no element"},
      {"text<a/>", "file:1:1: text before the root"},
      {"<a/>text", "file:1:5: content after the root"},
      {"<a/><b/>", "file:1:5: content after the root"},
      {"<a>\n <b></c></a>", "file:2:5: a/b: </c> closes <b>"},
      {"<a name='x'><b></a>", "file:1:16: a[x]/b: </a> closes <b>"},
      {"<a>\n  <b>", "file:2:3: a/b: element \"b\" without an end"},
      {"<a", "file:1:3: a: the text ends inside a tag"},
      {"<a b", "file:1:5: a: attribute \"b\" without a value"},
      {"<a b=1/>", "file:1:6: a: attribute value without quotation marks"},
      {"<a b='1/>", "file:1:6: a: attribute value without an end"},
      {"<a b='1' b='2'/>", "file:1:10: a: attribute \"b\" is there twice"},
      {"<a b='1'c='2'/>", "file:1:9: a: no space before an attribute"},
      {"<a b='<'/>", "file:1:7: a: \"<\" in an attribute value"},
      {"<a b='&nbsp;'/>", "file:1:7: a: unknown reference \"&nbsp;\""},
      {"<a b='&#0;'/>", "file:1:7: a: unknown reference \"&#0;\""},
      {"<a b='&#xd800;'/>", "file:1:7: a: unknown reference"},
      {"<a b='&#x110000;'/>", "file:1:7: a: unknown reference"},
      {"<a b='&#12a;'/>", "file:1:7: a: unknown reference"},
      {"<a>a & b</a>", "file:1:6: a: \"&\" that starts no reference"},
      {"<a><!-- b</a>", "file:1:4: a: comment without an end"},
      {"<!DOCTYPE a><a/>", "file:1:1: DOCTYPE"},
      {"<a><![CDATA[x]]></a>", "file:1:4: a: CDATA section"},
      {"<a><?run it?></a>", "file:1:4: a: processing instruction"},
      {" <?xml version='1.0'?><a/>", "file:1:2: processing instruction"},
      {"<?xml version='1.0'><a/>", "file:1:20: XML declaration without an end"},
      {"<?xml encoding='utf-8'?><a/>", "file:1:1: XML declaration without a version"},
      {"<?xml version='2.0'?><a/>", "file:1:7: XML version \"2.0\""},
      {"<?xml version='1.0' encoding='latin1'?><a/>", "file:1:21: encoding \"latin1\""},
      {"<1a/>", "file:1:2: unexpected \"1\""},
      {"<a / >", "file:1:4: a: unexpected \"/\""},
      {"</a>", "file:1:2: unexpected \"/\""},
      {"<a>\x01</a>", "file:1:4: control character"},
      {"<a>\xff</a>", "file:1:4: bytes that are not UTF-8"},
      {"<a></a", "file:1:7: a: closing tag without an end"},
  };
  for (const Malformed& malformed : cases) expect_input_error(parse_xml, malformed);
}

}  // namespace
}  // namespace nearfield::host
